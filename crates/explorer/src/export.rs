//! Exports the page as one file that needs neither a server nor a network: with all scripts, the interface as
//! WebAssembly, and the input.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Map, Value, json};
use thiserror::Error;

use crate::named::Named;
use crate::page::{INDEX, PageFile};

/// Path of the interface's module among the files of the page.
const MODULE: &str = "wasm/explorer.wasm";
/// Prefix of the names under which scripts import each other in an exported page.
const SCOPE: &str = "page/";
/// Id of the element that holds module and input.
const ELEMENT: &str = "touchdown-engine";
/// Text before the path of an imported script.
const IMPORTS: [&str; 3] = ["from", "import", "import("];

/// Reason why the page cannot be exported: a fault of the program.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("the page cannot be exported: {0}")]
pub struct ExportError(String);

/// The page with everything embedded.
///
/// # Errors
/// If the program lacks a part of its page.
pub fn page(named: &Named) -> Result<String, ExportError> {
    let index = text(&file(INDEX)?)?;
    let with_styles = replaced(index, "<link rel=\"stylesheet\" href=\"", "\">", |path| {
        Ok(format!("<style>\n{}</style>", text(&file(path)?)?))
    })?;
    let mut is_first = true;
    replaced(
        &with_styles,
        "<script type=\"module\" src=\"",
        "\"></script>",
        |path| {
            let inside = if is_first {
                inside(named)?
            } else {
                String::new()
            };
            is_first = false;
            let script = in_script(&json!(format!("{SCOPE}{path}")));
            Ok(format!(
                "{inside}<script type=\"module\">import {script};</script>"
            ))
        },
    )
}

/// Data that scripts need before they start: each other, the module and the input.
fn inside(named: &Named) -> Result<String, ExportError> {
    let module = file(MODULE)?;
    if !module.is_gzip {
        return Err(ExportError(format!("{MODULE} is not compressed")));
    }
    let copies: Vec<Value> = (named.copies.iter())
        .map(|copy| json!({"path": copy.path, "text": copy.text}))
        .collect();
    let opened = json!({
        "files": named.files,
        "copies": copies,
        "units": named.units.to_string(),
    });
    let engine = json!({"module": STANDARD.encode(module.bytes), "opened": opened});
    let mut imports = Map::new();
    for script in PageFile::all().filter(|file| file.path.ends_with(".js")) {
        let source = imports_by_name(script.path, text(&script)?);
        let address = format!("data:text/javascript;base64,{}", STANDARD.encode(source));
        imports.insert(format!("{SCOPE}{}", script.path), json!(address));
    }
    Ok(format!(
        "<script type=\"importmap\">{}</script>\n<script type=\"application/json\" id=\"{ELEMENT}\">{}</script>\n",
        in_script(&json!({ "imports": imports })),
        in_script(&engine)
    ))
}

/// JSON with escapes, so that nothing in it ends the enclosing script.
fn in_script(json: &Value) -> String {
    json.to_string().replace('<', "\\u003c")
}

/// A script with its relative import paths replaced by names.
fn imports_by_name(path: &str, source: &str) -> String {
    let mut parts = source.split_inclusive(['"', '\'']).peekable();
    let mut named = String::with_capacity(source.len());
    while let Some(part) = parts.next() {
        named.push_str(part);
        let before = part.trim_end_matches(['"', '\'']).trim_end();
        let is_import = IMPORTS.iter().any(|word| before.ends_with(word));
        let is_relative = |next: &&str| next.starts_with("./") || next.starts_with("../");
        if is_import && let Some(imported) = parts.next_if(|next| is_relative(next)) {
            named.push_str(SCOPE);
            named.push_str(&joined(path, imported));
        }
    }
    named
}

/// Resolves a path relative to a file.
fn joined(file: &str, relative: &str) -> String {
    let mut steps: Vec<&str> = file.split('/').collect();
    steps.pop();
    for step in relative.split('/') {
        match step {
            "." => {}
            ".." => drop(steps.pop()),
            step => steps.push(step),
        }
    }
    steps.join("/")
}

/// Replaces everything from `begin` to `end`, inclusive.
fn replaced(
    mut rest: &str,
    begin: &str,
    end: &str,
    mut by: impl FnMut(&str) -> Result<String, ExportError>,
) -> Result<String, ExportError> {
    let mut whole = String::new();
    while let Some((before, after)) = rest.split_once(begin) {
        let (between, after) =
            (after.split_once(end)).ok_or_else(|| ExportError(format!("{begin} without {end}")))?;
        whole.push_str(before);
        whole.push_str(&by(between)?);
        rest = after;
    }
    whole.push_str(rest);
    Ok(whole)
}

fn file(path: &str) -> Result<PageFile, ExportError> {
    PageFile::at(path).ok_or_else(|| ExportError(format!("{path} is missing")))
}

fn text(file: &PageFile) -> Result<&'static str, ExportError> {
    std::str::from_utf8(file.bytes).map_err(|_| ExportError(format!("{} is not a text", file.path)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_become_names() {
        let source = "import { a } from \"../look/a.js\";\nimport './b.js'; const c = await import(\"./c/d.js\");\n\
                      import T from \"three\"; say(\"./no.js\"); export * from\"./e.js\";";
        assert_eq!(
            imports_by_name("map/m.js", source),
            "import { a } from \"page/look/a.js\";\nimport 'page/map/b.js'; const c = await import(\"page/map/c/d.js\");\n\
             import T from \"three\"; say(\"./no.js\"); export * from\"page/map/e.js\";"
        );
    }

    #[test]
    fn no_input_ends_its_script() {
        let text = in_script(&json!({"text": "</script><script>"}));
        assert!(!text.contains('<'), "{text}");
        let again: Value = serde_json::from_str(&text).unwrap();
        assert_eq!(again["text"], "</script><script>");
    }
}
