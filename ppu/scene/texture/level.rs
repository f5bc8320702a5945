//! The levels of a texture.

use std::sync::LazyLock;

use scenes::Texture;

/// The light of each byte of a screen's values (sRGB).
static LIGHT: LazyLock<[f32; 256]> = LazyLock::new(|| {
    std::array::from_fn(|byte| {
        let value = byte as f64 / 255.0;
        let light =
            if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) };
        light as f32
    })
});

/// 255 times the square root of the light that a byte of a screen's values stands for.
pub(super) fn root(byte: u8) -> u8 {
    libm::roundf(255.0 * libm::sqrtf(LIGHT[usize::from(byte)])) as u8
}

/// A texture at one size.
pub(super) struct Level {
    width: usize,
    texels: Vec<[u8; 3]>,
}

impl Level {
    /// The largest one.
    pub fn new(texture: &Texture) -> Self {
        Self { width: texture.width() as usize, texels: texture.texels().to_vec() }
    }

    pub fn width(&self) -> usize {
        self.width
    }

    pub fn height(&self) -> usize {
        self.texels.len() / self.width
    }

    pub fn texel(&self, x: usize, y: usize) -> [u8; 3] {
        self.texels[y * self.width + x]
    }

    /// The level with half as many texels across and down, rounded down, but at least one; `None`
    /// if this one has one texel. The light of a texel is the mean over its area.
    pub fn half(&self) -> Option<Self> {
        let (width, height) = (self.width(), self.height());
        if width * height == 1 {
            return None;
        }
        let columns = parts(width);
        let mut texels = Vec::with_capacity(columns.len() * (height / 2).max(1));
        for row in parts(height) {
            texels.extend(columns.iter().map(|column| {
                let mut light = [0.0_f32; 3];
                for (y, down) in row.covered() {
                    for (x, across) in column.covered() {
                        let texel = self.texel(x, y);
                        for (sum, byte) in light.iter_mut().zip(texel) {
                            *sum += down * across * LIGHT[usize::from(byte)];
                        }
                    }
                }
                light.map(encoded)
            }));
        }
        let width = columns.len();
        Some(Self { width, texels })
    }
}

/// The texels of a row that one of the next level covers: the first of them, and the part of the
/// new one that each is.
struct Part {
    first: usize,
    parts: [f32; 3],
}

impl Part {
    fn covered(&self) -> impl Iterator<Item = (usize, f32)> {
        let covered = (self.first..).zip(self.parts);
        covered.filter(|(_, part)| *part > 0.0)
    }
}

/// The parts of a row of `count` texels that the texels of the next level cover. An odd row is cut
/// between its texels by steps of 1 / count: of n = (count - 1) / 2 new ones, the texel number k
/// has the parts n - k, n and k + 1 of three old ones, divided by count.
fn parts(count: usize) -> Vec<Part> {
    if count == 1 {
        return vec![Part { first: 0, parts: [1.0, 0.0, 0.0] }];
    }
    let half = count / 2;
    let part = |number: usize| {
        let parts = if count.is_multiple_of(2) {
            [0.5, 0.5, 0.0]
        } else {
            [half - number, half, number + 1].map(|part| part as f32 / count as f32)
        };
        Part { first: 2 * number, parts }
    };
    (0..half).map(part).collect()
}

/// Light as a byte of a screen's values.
fn encoded(light: f32) -> u8 {
    let light = f64::from(light);
    let value = if light <= 0.003_130_8 {
        12.92 * light
    } else {
        1.055 * libm::pow(light, 1.0 / 2.4) - 0.055
    };
    libm::round(255.0 * value) as u8
}
