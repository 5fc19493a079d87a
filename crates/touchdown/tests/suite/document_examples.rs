//! Every example of the documents works.
//!
//! A fenced block says by its info string what it is:
//!
//! * `toml sweep NAME`, `toml scene NAME`, `toml vehicle NAME`, `csv NAME`: a file that commands of the page
//!   read. A sweep that none of them runs is checked with `--dry-run`;
//! * `sh run`: commands that run here and must succeed;
//! * `sh`: commands that take too long. Their options must parse;
//! * `python`: what the tests of the Python package run;
//! * `sh other`: commands of other programs, and commands whose output goes outside of the folder. Those of
//!   `touchdown` only print, and are run.
//!
//! The blocks of a page share a folder, which has `sweeps/` and the other files of the repository that they read.

#![allow(missing_docs, reason = "tests are not an interface")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use tempfile::TempDir;

/// A fenced block of a page.
struct Block {
    line: usize,
    info: Vec<String>,
    text: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn blocks(page: &str) -> Vec<Block> {
    let text = fs::read_to_string(root().join(page)).unwrap();
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for (index, line) in text.lines().enumerate() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(info), None) => {
                let info = info.split_whitespace().map(str::to_owned).collect();
                open = Some(Block {
                    line: index + 1,
                    info,
                    text: String::new(),
                });
            }
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (None, Some(block)) => {
                block.text.push_str(line);
                block.text.push('\n');
            }
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "{page}: a block is not closed");
    blocks
}

fn copy_tree(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        match entry.file_type().unwrap().is_dir() {
            true => copy_tree(&entry.path(), &target),
            false => drop(fs::copy(entry.path(), target).unwrap()),
        }
    }
}

/// The commands of a block for this program: one a line, continued lines joined, comments dropped.
fn commands(text: &str) -> Vec<Vec<String>> {
    let joined = text.replace("\\\n", " ");
    let of_program = |line: &str| {
        let line = line.split(" #").next().unwrap_or_default().trim();
        let line = line.split(" > ").next().unwrap_or_default();
        let rest = line
            .strip_prefix("cargo run --release -- ")
            .or_else(|| line.strip_prefix("touchdown "))?;
        Some(
            rest.split_whitespace()
                .map(|word| word.trim_matches('"').to_owned())
                .collect(),
        )
    };
    joined.lines().filter_map(of_program).collect()
}

fn run(folder: &Path, arguments: &[String]) -> Result<String, String> {
    let done = Command::new(env!("CARGO_BIN_EXE_touchdown"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    match done.status.success() {
        true => Ok(String::from_utf8_lossy(&done.stdout).into_owned()),
        false => Err(String::from_utf8_lossy(&done.stderr).into_owned()),
    }
}

/// Whether a block is commands that are run, and one of them reads the file `name`.
fn runs(block: &Block, name: &str) -> bool {
    block.info == ["sh", "run"] && block.text.split_whitespace().any(|word| word == name)
}

/// Does what a block of a page asks for; what went wrong, if anything did.
fn check(folder: &Path, block: &Block, page: &[Block]) -> Result<(), String> {
    let info: Vec<&str> = block.info.iter().map(String::as_str).collect();
    let write = |name: &str| fs::write(folder.join(name), &block.text).unwrap();
    match info[..] {
        ["toml", "sweep", name] => {
            write(name);
            if page.iter().any(|block| runs(block, name)) {
                return Ok(());
            }
            let check = ["sweep", name, "--dry-run"].map(str::to_owned);
            run(folder, &check).map(drop)
        }
        ["toml", "scene" | "vehicle", name] | ["csv", name] => {
            write(name);
            match page.iter().any(|block| block.text.contains(name)) {
                true => Ok(()),
                false => Err(format!("nothing reads {name}")),
            }
        }
        ["sh", "run" | "other"] => commands(&block.text)
            .iter()
            .try_for_each(|command| run(folder, command).map(drop)),
        ["sh"] => {
            for mut command in commands(&block.text) {
                command.push("--help".to_owned());
                run(folder, &command)?;
            }
            Ok(())
        }
        ["text"] => Ok(()),
        // The tests of the Python package run these.
        ["python"] => Ok(()),
        _ => Err(format!("no such kind of block: {}", info.join(" "))),
    }
}

fn check_page(page: &str) {
    let folder = TempDir::new().unwrap();
    for tree in ["sweeps", "results/trade", "crates/input/src/readers/deck"] {
        copy_tree(&root().join(tree), &folder.path().join(tree));
    }
    let blocks = blocks(page);
    assert!(blocks.len() > 5, "{page} has {} examples", blocks.len());
    for block in &blocks {
        if let Err(said) = check(folder.path(), block, &blocks) {
            panic!("{page}, line {}: {said}", block.line);
        }
    }
}

#[test]
fn examples_of_the_readme_work() {
    check_page("README.md");
}

#[test]
fn examples_of_the_guide_work() {
    check_page("docs/guide.md");
}

#[test]
fn examples_of_the_page_on_own_landers_work() {
    check_page("docs/own-lander.md");
}

#[test]
fn commands_of_the_gallery_work() {
    check_page("docs/gallery.md");
}
