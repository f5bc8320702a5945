//! The options that replace parts of a scene's view.

use clap::Args;

use crate::game::DVec3;

/// Another view than the scene's own.
#[derive(Args)]
#[command(next_help_heading = "View")]
pub struct Camera {
    /// Position of the eye [default: the scene's]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    from: Option<DVec3>,
    /// Point that the eye looks at [default: the scene's]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    look_at: Option<DVec3>,
    /// Up direction [default: the scene's]
    #[arg(long, value_name = "X,Y,Z", allow_hyphen_values = true, value_parser = point)]
    up: Option<DVec3>,
    /// Vertical field of view in degrees [default: the scene's]
    #[arg(long, value_name = "DEGREES", allow_hyphen_values = true)]
    angle: Option<f64>,
}

impl Camera {
    /// Changes a view.
    pub fn place(&self, view: &mut scenes::View) {
        let scenes::View { from, at, up, angle, .. } = view;
        *from = self.from.unwrap_or(*from);
        *at = self.look_at.unwrap_or(*at);
        *up = self.up.unwrap_or(*up);
        *angle = self.angle.unwrap_or(*angle);
    }
}

/// Parses a point or a direction such as 1,2.5,-3.
fn point(text: &str) -> Result<DVec3, String> {
    let numbers: Vec<f64> = text
        .split(',')
        .map_while(|number| number.trim().parse().ok())
        .filter(|number: &f64| number.is_finite())
        .collect();
    match <[f64; 3]>::try_from(numbers) {
        Ok(numbers) if text.split(',').count() == 3 => Ok(numbers.into()),
        _ => Err("three finite numbers with commas between, such as 1,2.5,-3".into()),
    }
}
