//! Checks that links in the documents lead to existing files and headings, and that paths in
//! backquotes name existing files.

use crate::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Paths that documents use as examples and that need not exist.
const EXAMPLES: &[&str] = &[
    // The formulation that CONTRIBUTING.md adds as an example.
    "lab/spu/include/sphere_mine.inc",
    "lab/spu/isect/isect_pairs_mine_r16.s",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// All files below a folder of the repository, relative to its root, without build output and
/// hidden files.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(root().join(folder)).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name();
        let path = folder.join(&name);
        if name == "target" || name.as_encoded_bytes().starts_with(b".") {
            continue;
        }
        match entry.file_type().unwrap() {
            kind if kind.is_dir() => found.extend(files(&path)),
            kind if kind.is_file() => found.push(path),
            _ => {}
        }
    }
    found
}

pub fn read(path: &Path) -> String {
    fs::read_to_string(root().join(path)).unwrap()
}

/// A document without its code blocks.
fn prose(text: &str) -> String {
    let (mut prose, mut fenced, mut indented) = (String::new(), false, true);
    for line in text.lines() {
        let code = fenced || indented && line.starts_with("    ");
        if line.starts_with("```") {
            fenced = !fenced;
        } else if !code {
            indented = line.is_empty();
            prose.push_str(line);
            prose.push('\n');
        }
    }
    prose
}

/// Splits a text into the spans in backquotes and the rest.
fn parted(prose: &str) -> (Vec<&str>, String) {
    let (mut spans, mut rest) = (Vec::new(), String::new());
    for paragraph in prose.split("\n\n") {
        for (place, part) in paragraph.split('`').enumerate() {
            if place % 2 == 1 {
                spans.push(part);
            } else {
                rest.push_str(part);
            }
        }
        rest.push('\n');
    }
    (spans, rest)
}

/// The anchors of a document's headings, as GitHub makes them.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut times = BTreeMap::new();
    let prose = prose(text);
    let headings = prose.lines().filter(|line| line.starts_with('#'));
    let anchor = |line: &str| {
        let heading = line.trim_start_matches('#').trim().to_lowercase();
        let kept = heading.chars().filter(|&c| c.is_alphanumeric() || " -_".contains(c));
        let anchor: String = kept.map(|c| if c == ' ' { '-' } else { c }).collect();
        let before = times.entry(anchor.clone()).or_insert(0);
        *before += 1;
        match *before {
            1 => anchor,
            repeated => format!("{anchor}-{}", repeated - 1),
        }
    };
    headings.map(anchor).collect()
}

/// The error in a link with this target, in a document in `folder` with this text.
fn broken(link: &str, folder: &Path, text: &str) -> Option<String> {
    if link.starts_with("https://") || link.starts_with("http://") {
        return None;
    }
    let (path, anchor) = link.split_once('#').unwrap_or((link, ""));
    let target = root().join(folder).join(path);
    if !target.exists() {
        return Some(format!("no file {path}"));
    }
    if anchor.is_empty() {
        return None;
    }
    let found = match path {
        "" => anchors(text),
        _ => anchors(&fs::read_to_string(target).ok()?),
    };
    (!found.contains(anchor)).then(|| format!("no heading for #{anchor}"))
}

/// The errors in the links of a document in `folder`, and the number of its links.
fn check(folder: &Path, text: &str) -> (Vec<String>, usize) {
    let prose = prose(text);
    let (_, rest) = parted(&prose);
    let links: Vec<_> = rest.split("](").skip(1).filter_map(|link| link.split_once(')')).collect();
    let wrong = links.iter().filter_map(|(link, _)| broken(link, folder, text)).collect();
    (wrong, links.len())
}

#[test]
fn every_link_has_a_target() {
    let documents = files(Path::new(""));
    let documents =
        documents.iter().filter(|path| path.extension().is_some_and(|ending| ending == "md"));
    let (mut wrong, mut links) = (Vec::new(), 0);
    for path in documents {
        let (bad, count) = check(path.parent().unwrap(), &read(path));
        wrong.extend(bad.iter().map(|why| format!("{}: {why}", path.display())));
        links += count;
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(links > 100, "only {links} links found");
}

#[test]
fn every_path_in_backquotes_exists() {
    let all = files(Path::new(""));
    let is_below_a_folder = |span: &str| match span.split_once('/') {
        // An absolute path belongs to another system.
        Some(("", _)) | None => false,
        Some((folder, _)) => all.iter().any(|path| path.starts_with(folder)),
    };
    let is_path = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    let (mut wrong, mut paths) = (Vec::new(), 0);
    for document in all.iter().filter(|path| path.extension().is_some_and(|end| end == "md")) {
        let prose = prose(&read(document));
        for span in parted(&prose).0 {
            let (path, name) = span.split_once(": ").unwrap_or((span, ""));
            if !path.chars().all(is_path) || EXAMPLES.contains(&path) {
                continue;
            }
            let exists = match name {
                "" if !is_below_a_folder(path) => continue,
                // From the repository's root or from the document's folder.
                "" => [Path::new(""), document.parent().unwrap()]
                    .iter()
                    .any(|folder| root().join(folder).join(path).exists()),
                // A function: `engine.rs: Engine::start`. The folder may be left out.
                _ if path.contains('.') && !name.contains(' ') => all.iter().any(|file| {
                    let function = name.rsplit("::").next().unwrap_or(name);
                    file.ends_with(path) && read(file).contains(function)
                }),
                _ => continue,
            };
            paths += 1;
            if !exists {
                wrong.push(format!("{}: {span}", document.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(paths > 100, "only {paths} paths found");
}

#[test]
fn broken_link_is_found() {
    let text = "# A heading, `code`: two\n\n## Again\n\n## Again\n\n```\n# no heading\n```\n";
    let expected = ["a-heading-code-two", "again", "again-1"];
    assert_eq!(anchors(text), expected.map(String::from).into());
    for (link, wrong) in [
        ("docs/play.md", None),
        ("docs/play.md#keys", None),
        ("#again-1", None),
        ("https://example.org/none", None),
        ("docs/none.md", Some("no file docs/none.md")),
        ("docs/play.md#none", Some("no heading for #none")),
        ("#no-heading", Some("no heading for #no-heading")),
    ] {
        let (found, count) = check(Path::new(""), &format!("{text}\n[a]({link}) `[b](c)`\n"));
        assert_eq!(found, wrong.map(String::from).into_iter().collect::<Vec<_>>());
        assert_eq!(count, 1, "{link}");
    }
}
