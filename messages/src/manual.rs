//! Writes man pages and shell completions from the definition of a program's command line.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use clap::{Args, Command, ValueEnum as _};
use clap_complete::Shell;

/// The arguments of a program's hidden command `pages`.
#[derive(Clone, Debug, Args)]
pub struct Arguments {
    /// Folder to write to; the subfolders man and completions are created in it
    folder: PathBuf,
}

/// Writes a program's man pages, one for each command, to `man` in the folder, and its completions
/// for every shell that clap supports to `completions`.
///
/// # Errors
///
/// Fails if a folder or file can't be written. The message names the folder.
pub fn write(mut command: Command, arguments: &Arguments) -> io::Result<()> {
    let folder = &arguments.folder;
    into(&mut command, folder)
        .map_err(|error| io::Error::new(error.kind(), format!("{}: {error}", folder.display())))
}

fn into(command: &mut Command, folder: &Path) -> io::Result<()> {
    let [man, completions] = ["man", "completions"].map(|name| folder.join(name));
    fs::create_dir_all(&man)?;
    fs::create_dir_all(&completions)?;
    let name = command.get_name().to_owned();
    for shell in Shell::value_variants() {
        clap_complete::generate_to(*shell, command, &name, &completions)?;
    }
    clap_mangen::generate_to(command.clone(), &man)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_visible_command_has_a_page() {
        let folder = tempfile::tempdir().unwrap();
        let command = Command::new("tracer")
            .about("Traces")
            .subcommand(Command::new("render").about("Renders"))
            .subcommand(Command::new("pages").hide(true));
        let arguments = Arguments { folder: folder.path().to_path_buf() };
        write(command, &arguments).unwrap();
        let page = fs::read_to_string(folder.path().join("man/tracer-render.1")).unwrap();
        assert!(page.contains("Renders"));
        assert!(!folder.path().join("man/tracer-pages.1").exists());
        let bash = fs::read_to_string(folder.path().join("completions/tracer.bash")).unwrap();
        assert!(bash.contains("render"));
    }

    #[test]
    fn a_folder_that_cannot_be_written_is_named() {
        let arguments = Arguments { folder: "/dev/null/pages".into() };
        let error = write(Command::new("tracer"), &arguments).unwrap_err();
        assert!(error.to_string().starts_with("/dev/null/pages: "));
    }
}
