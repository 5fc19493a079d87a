/**
 * Plays a landing once and records the picture.
 * @param {import("../landing/stage.js").Stage} stage
 * @param {import("../landing/player.js").Player} player
 * @param {AbortSignal} signal ends the recording early
 * @returns {Promise<Blob>} a WebM file
 */
export async function record(stage, player, signal) {
  const type = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"].find((known) => MediaRecorder.isTypeSupported(known));
  if (!type) throw new Error("this browser does not record WebM");
  stage.keepsSize = true;
  const stream = stage.canvas.captureStream(30);
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 6e6 });
  /** @type {Blob[]} */
  const pieces = [];
  recorder.addEventListener("dataavailable", ({ data }) => pieces.push(data));
  const stopped = new Promise((resolve) => recorder.addEventListener("stop", resolve));
  player.pause();
  player.go(0);
  recorder.start(500);
  const ended = new Promise((resolve) => {
    player.addEventListener("state", () => player.isPlaying || resolve(undefined));
    signal.addEventListener("abort", () => {
      player.pause();
      resolve(undefined);
    });
  });
  player.play();
  await ended;
  // The last picture stays for a moment.
  await new Promise((resolve) => setTimeout(resolve, 400));
  recorder.stop();
  await stopped;
  for (const track of stream.getTracks()) track.stop();
  stage.keepsSize = false;
  stage.draw();
  return new Blob(pieces, { type: "video/webm" });
}
