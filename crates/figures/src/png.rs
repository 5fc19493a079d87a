//! Pictures as PNG, rendered from their SVG with a bundled font.

use std::sync::Arc;

use png::{BitDepth, ColorType, Compression, Encoder, FilterType};
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree, fontdb};

use crate::words::FigureError;

/// DejaVu Sans, reduced to the letters that pictures use: system fonts differ between machines.
const FONT: &[u8] = include_bytes!("../fonts/DejaVuSans-subset.ttf");
const FAMILY: &str = "DejaVu Sans";
/// Pixels of the PNG for each pixel of the SVG.
pub const SCALE: f32 = 2.0;

/// Renders an SVG picture as PNG, [`SCALE`] times as large, on white paper.
///
/// # Errors
/// When `svg` is no picture, or too large for memory.
pub fn render(svg: &str) -> Result<Vec<u8>, FigureError> {
    let mut fonts = fontdb::Database::new();
    fonts.load_font_data(FONT.to_vec());
    fonts.set_sans_serif_family(FAMILY);
    let options = Options {
        font_family: FAMILY.to_owned(),
        fontdb: Arc::new(fonts),
        ..Options::default()
    };
    let failed = |error: &dyn std::fmt::Display| FigureError::Rendering(error.to_string());
    let tree = Tree::from_str(svg, &options).map_err(|error| failed(&error))?;
    let size = tree.size();
    let [width, height] = [size.width(), size.height()].map(|side| (side * SCALE).ceil() as u32);
    let mut pixels = Pixmap::new(width, height)
        .ok_or_else(|| failed(&format!("{width} by {height} pixels are too many")))?;
    pixels.fill(Color::WHITE);
    resvg::render(
        &tree,
        Transform::from_scale(SCALE, SCALE),
        &mut pixels.as_mut(),
    );
    encode(&pixels).map_err(|error| failed(&error))
}

/// Encodes opaque pixels. Even areas and lines are smallest without a filter: the best compression with a filter takes
/// four times as long and up to a third more space.
fn encode(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Default);
    encoder.set_filter(FilterType::NoFilter);
    let mut colours = Vec::with_capacity(3 * pixels.pixels().len());
    for pixel in pixels.data().chunks_exact(4) {
        colours.extend_from_slice(&pixel[..3]);
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&colours)?;
    writer.finish()?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = r##"<svg width="40" height="30" viewBox="0 0 40 30"
        xmlns="http://www.w3.org/2000/svg"><rect width="40" height="30" fill="#ffffff"/>
        <rect x="10" y="10" width="10" height="10" fill="#ff0000"/>TEXT</svg>"##;

    fn pixels(svg: &str) -> Pixmap {
        Pixmap::decode_png(&render(svg).unwrap()).unwrap()
    }

    #[test]
    fn marks_keep_their_places_and_colours() {
        let picture = pixels(SQUARE);
        assert_eq!((picture.width(), picture.height()), (80, 60));
        let red = picture.pixel(30, 30).unwrap();
        assert_eq!((red.red(), red.green()), (255, 0));
        assert_eq!(picture.pixel(10, 10).unwrap().green(), 255);
    }

    #[test]
    fn text_is_drawn_without_system_fonts() {
        let text =
            r#"<text x="2" y="25" font-size="12" font-family="Helvetica, sans-serif">λΞ</text>"#;
        let dark = |picture: Pixmap| {
            picture
                .pixels()
                .iter()
                .filter(|p| p.green() < 80 && p.red() < 80)
                .count()
        };
        assert!(dark(pixels(&SQUARE.replace("TEXT", text))) > 20);
        assert_eq!(dark(pixels(SQUARE)), 0);
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        assert!(render("no picture").is_err());
    }
}
