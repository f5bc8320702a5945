//! `cellray new`: a folder with a game that is a crate of its own.

use std::fs;
use std::path::{Path, PathBuf};

use clap::Args;

use super::Outcome;

/// The sources that this program was built from.
const SOURCES: &str = env!("CARGO_MANIFEST_DIR");

const MAIN: &str = include_str!("new/main.rs");

/// Make a folder with a game of your own, ready to run.
#[derive(Args)]
pub struct Arguments {
    /// Folder to make; its name is the game's
    folder: PathBuf,
    /// Folder of cellray's sources that the game depends on [default: those that this program was
    /// built from]
    #[arg(long, value_name = "FOLDER", conflicts_with = "git")]
    path: Option<PathBuf>,
    /// Git repository of cellray that the game depends on
    #[arg(long, value_name = "ADDRESS")]
    git: Option<String>,
}

pub fn run(arguments: &Arguments) -> Outcome {
    let folder = &arguments.folder;
    let name = package_name(folder)?;
    let dependencies = arguments.dependencies()?;
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n\
         [dependencies]\n{dependencies}\n\
         # Without optimisation the emulated SPUs are slow.\n\
         [profile.dev]\nopt-level = 2\n"
    );
    let failed = |path: &Path| {
        let path = path.display().to_string();
        move |error: std::io::Error| format!("{path}: {error}")
    };
    fs::create_dir(folder).map_err(failed(folder))?;
    let sources = folder.join("src");
    fs::create_dir(&sources).map_err(failed(&sources))?;
    let files = [
        (folder.join("Cargo.toml"), manifest.as_str()),
        (folder.join(".gitignore"), "/target\n"),
        (sources.join("main.rs"), MAIN),
    ];
    for (path, text) in &files {
        fs::write(path, text).map_err(failed(path))?;
    }
    eprintln!(
        "cellray: made {0}; next: cd {0} && cargo run --release",
        folder.display()
    );
    Ok(())
}

impl Arguments {
    /// The lines of the manifest that name cellray's crates.
    fn dependencies(&self) -> Result<String, String> {
        if let Some(address) = &self.git {
            let address = toml_string(address)?;
            return Ok(format!(
                "cellray = {{ git = {address} }}\ncellray-play = {{ git = {address} }}\n"
            ));
        }
        let path = self.path.clone().unwrap_or_else(|| PathBuf::from(SOURCES));
        if !path.join("play/Cargo.toml").is_file() {
            return Err(format!(
                "{}: cellray's sources are not there; name their folder by --path or their \
                 repository by --git",
                path.display()
            ));
        }
        let path =
            fs::canonicalize(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let crate_at = |path: &Path| match path.to_str() {
            Some(path) => toml_string(path),
            None => Err(format!("{}: the path is not UTF-8", path.display())),
        };
        Ok(format!(
            "cellray = {{ path = {} }}\ncellray-play = {{ path = {} }}\n",
            crate_at(&path)?,
            crate_at(&path.join("play"))?
        ))
    }
}

/// A folder's name, if cargo takes it as a package's.
fn package_name(folder: &Path) -> Result<&str, String> {
    let name = folder.file_name().and_then(|name| name.to_str());
    let name = name.ok_or_else(|| format!("{}: not a folder's name", folder.display()))?;
    let is_first = |first: char| first.is_ascii_alphabetic() || first == '_';
    let is_other = |other: char| other.is_ascii_alphanumeric() || other == '_' || other == '-';
    if name.starts_with(is_first) && name.chars().all(is_other) {
        Ok(name)
    } else {
        Err(format!(
            "{name}: a package's name has letters, digits, - and _, and begins with a letter or _"
        ))
    }
}

/// A string in TOML's quotes.
fn toml_string(text: &str) -> Result<String, String> {
    if text.chars().any(char::is_control) {
        return Err(format!(
            "{text:?}: no address or path has control characters"
        ));
    }
    let quoted = text.replace('\\', "\\\\").replace('"', "\\\"");
    Ok(format!("\"{quoted}\""))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_packages() {
        assert_eq!(package_name(Path::new("/tmp/my-game")), Ok("my-game"));
        assert!(package_name(Path::new("2d")).is_err());
        assert!(package_name(Path::new("a game")).is_err());
        assert!(package_name(Path::new("..")).is_err());
    }

    #[test]
    fn strings_are_quoted() {
        assert_eq!(toml_string(r#"a"b\c"#).as_deref(), Ok(r#""a\"b\\c""#));
        assert!(toml_string("a\nb").is_err());
    }
}
