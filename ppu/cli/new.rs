//! `cellray new`: a folder with a game that is a crate of its own.

use std::fs;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::Outcome;

/// The sources that this program was built from.
const SOURCES: &str = env!("CARGO_MANIFEST_DIR");

/// A game to begin with: one of the tutorial's, whose files the links in `new/` lead to.
#[derive(Clone, Copy, Debug, Default, ValueEnum)]
enum Template {
    /// A ball that jumps
    #[default]
    Ball,
    /// A ball to steer over a mirror, with a recorded session
    Steer,
    /// A planet with a shader of its own; needs an SPU assembler
    Stripes,
}

impl Template {
    /// Its files, by their paths in the game's folder.
    fn files(self) -> &'static [(&'static str, &'static [u8])] {
        match self {
            Self::Ball => &[("src/main.rs", include_bytes!("new/ball.rs"))],
            Self::Steer => &[
                ("src/main.rs", include_bytes!("new/steer.rs")),
                ("played.session", include_bytes!("new/played.session")),
            ],
            Self::Stripes => &[
                ("src/main.rs", include_bytes!("new/stripes.rs")),
                ("build.rs", include_bytes!("new/build.rs")),
                ("shaders/stripes.s", include_bytes!("new/stripes.s")),
            ],
        }
    }

    /// The crates of cellray that it depends on, by their folders.
    fn crates(self) -> &'static [(&'static str, &'static [(&'static str, &'static str)])] {
        const GAME: (&str, &[(&str, &str)]) =
            ("dependencies", &[("cellray", ""), ("cellray-play", "play")]);
        match self {
            Self::Ball | Self::Steer => &[GAME],
            Self::Stripes => &[GAME, ("build-dependencies", &[("spu-build", "linker")])],
        }
    }
}

/// Make a folder with a game of your own, ready to run.
#[derive(Args)]
pub struct Arguments {
    /// Folder to make; its name is the game's
    folder: PathBuf,
    /// The game to begin with
    #[arg(long, value_enum, default_value_t)]
    template: Template,
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
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n{}\n\
         # Without optimisation the emulated SPUs are slow.\n\
         [profile.dev]\nopt-level = 2\n",
        arguments.dependencies()?
    );
    let written = [
        ("Cargo.toml", manifest.as_bytes()),
        (".gitignore", b"/target\n".as_slice()),
    ];
    fs::create_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for (file, bytes) in written.iter().chain(arguments.template.files()) {
        let path = folder.join(file);
        let made = path.parent().map_or(Ok(()), fs::create_dir_all);
        made.and_then(|()| fs::write(&path, bytes))
            .map_err(|error| format!("{}: {error}", path.display()))?;
    }
    talk::say!(
        "cellray: made {0}; next: cd {0} && cargo run --release",
        folder.display()
    );
    Ok(())
}

impl Arguments {
    /// The parts of the manifest that name cellray's crates.
    fn dependencies(&self) -> Result<String, String> {
        let mut text = String::new();
        for (part, crates) in self.template.crates() {
            text += &format!("\n[{part}]\n");
            for (name, folder) in *crates {
                text += &format!("{name} = {{ {} }}\n", self.source(folder)?);
            }
        }
        Ok(text)
    }

    /// Where a crate in this folder of cellray's sources is found.
    fn source(&self, folder: &str) -> Result<String, String> {
        if let Some(address) = &self.git {
            return Ok(format!("git = {}", toml_string(address)?));
        }
        let sources = self.path.clone().unwrap_or_else(|| PathBuf::from(SOURCES));
        let path = sources.join(folder);
        let path = fs::canonicalize(&path)
            .ok()
            .filter(|path| path.join("Cargo.toml").is_file());
        let path = path.ok_or_else(|| {
            format!(
                "{}: cellray's sources are not there; name their folder by --path or their \
                 repository by --git",
                sources.display()
            )
        })?;
        match path.to_str() {
            Some(path) => Ok(format!("path = {}", toml_string(path)?)),
            None => Err(format!("{}: the path is not UTF-8", path.display())),
        }
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
