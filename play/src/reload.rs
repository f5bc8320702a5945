//! A scene in front of a player that is loaded again when its files change.

use cellray::Scene;
use cellray::game::View;
use cellray::watch::Watch;

use crate::arguments::ViewArguments;
use crate::error::PlayError;
use crate::load;
use crate::viewer::Viewer;

/// A scene that is viewed, and its files.
pub struct Reload<'a> {
    arguments: &'a ViewArguments,
    watch: Watch,
}

impl<'a> Reload<'a> {
    /// Watches the files of a scene that is viewed with `--watch`; nothing without.
    pub fn new(arguments: &'a ViewArguments) -> Option<Self> {
        let files = [arguments.scene.scene.clone()].into_iter();
        let files = files.chain(arguments.options.program.files());
        arguments.watch.then(|| Self { arguments, watch: Watch::new(files) })
    }

    /// A viewer of the scene as it is now, seen from where the player is, if a file has changed.
    ///
    /// # Errors
    ///
    /// A scene or a shader that is wrong: the one before it is still good to look at.
    pub fn viewer(&mut self, view: &View) -> Option<Result<Viewer, PlayError>> {
        self.watch.has_changed().then(|| {
            let loaded = load(&self.arguments.scene)?;
            let render_options = self.arguments.scene.render_options();
            let program = self.arguments.options.settings()?.program;
            Scene::new(&loaded.scene, render_options, &program)?;
            Ok(Viewer::of(loaded, render_options).seen_from(view))
        })
    }
}
