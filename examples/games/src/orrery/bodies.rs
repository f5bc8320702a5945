//! A table of the bodies that orbit the sun.
//!
//! Invariant: no body ever passes through another. Each planet and each ring of the sun has its
//! own shell around the sun. A planet's shell is its ellipse, extended on both sides by the reach
//! of its moons and rings. Within it, each moon and each ring has its own shell around the planet.

pub(super) const SUN_RADIUS: f64 = 1.4;

pub(super) struct Planet {
    pub name: &'static str,
    pub radius: f64,
    /// The semi-major axis of its ellipse.
    pub distance: f64,
    /// The length of its year in days.
    pub period: f64,
    pub eccentricity: f64,
    /// In degrees.
    pub inclination: f64,
    /// The initial position in turns.
    pub start: f64,
    pub colour: [f64; 3],
    pub shine: f64,
}

macro_rules! planets {
    ($($name:literal $radius:literal $distance:literal $period:literal $eccentricity:literal
        $inclination:literal $start:literal $colour:expr, $shine:literal;)*) => {
        &[$(Planet {
            name: $name,
            radius: $radius,
            distance: $distance,
            period: $period,
            eccentricity: $eccentricity,
            inclination: $inclination,
            start: $start,
            colour: $colour,
            shine: $shine,
        }),*]
    };
}

/// The planets from the sun outwards.
pub(super) const PLANETS: &[Planet; 8] = planets! {
    "Mercury" 0.24  2.28    87.97 0.206 7.0 0.10 [0.66, 0.6, 0.55], 0.0;
    "Venus"   0.38  3.42   224.70 0.007 3.4 0.74 [0.93, 0.8, 0.52], 0.0;
    "Earth"   0.40  4.57   365.26 0.017 0.0 0.02 [0.24, 0.48, 0.95], 0.35;
    "Mars"    0.32  6.42   686.98 0.093 1.8 0.40 [0.86, 0.36, 0.2], 0.0;
    "Jupiter" 0.90 10.18  4332.59 0.049 1.3 0.43 [0.87, 0.7, 0.52], 0.0;
    "Saturn"  0.72 14.70 10759.22 0.057 2.5 0.20 [0.92, 0.82, 0.58], 0.0;
    "Uranus"  0.50 18.76 30688.50 0.046 0.8 0.62 [0.58, 0.86, 0.9], 0.0;
    "Neptune" 0.48 21.38 60182.00 0.010 1.8 0.06 [0.3, 0.42, 0.95], 0.0;
};

pub(super) struct Moon {
    pub name: &'static str,
    /// The index of its planet.
    pub planet: usize,
    pub radius: f64,
    pub distance: f64,
    pub period: f64,
    pub start: f64,
}

macro_rules! moons {
    ($($name:literal $planet:literal $radius:literal $distance:literal $period:literal
        $start:literal;)*) => {
        &[$(Moon {
            name: $name,
            planet: $planet,
            radius: $radius,
            distance: $distance,
            period: $period,
            start: $start,
        }),*]
    };
}

/// The largest moons. The orbit of Triton is retrograde.
pub(super) const MOONS: &[Moon; 9] = moons! {
    "Moon"     2 0.07  0.56  27.32 0.9;
    "Phobos"   3 0.03  0.39   0.32 0.0;
    "Deimos"   3 0.03  0.47   1.26 0.4;
    "Io"       4 0.06  1.04   1.77 0.1;
    "Europa"   4 0.055 1.17   3.55 0.6;
    "Ganymede" 4 0.075 1.33   7.15 0.3;
    "Callisto" 4 0.07  1.50  16.69 0.8;
    "Titan"    5 0.085 1.45  15.95 0.2;
    "Triton"   7 0.07  0.66  -5.88 0.5;
};

/// A ring of stones.
pub(super) struct Ring {
    /// The index of its planet, or `None` for a ring of the sun.
    pub planet: Option<usize>,
    pub stones: u32,
    /// The radius of a stone.
    pub stone: f64,
    /// The distance from the centre, and how far the stones deviate from it.
    pub distance: f64,
    pub width: f64,
    pub period: f64,
    /// In degrees.
    pub tilt: f64,
    pub colour: [f64; 3],
}

const SATURN: Ring = Ring {
    planet: Some(5),
    stones: 56,
    stone: 0.045,
    distance: 0.98,
    width: 0.03,
    period: 9.0,
    tilt: 26.7,
    colour: [0.86, 0.76, 0.58],
};

/// Two rings of Saturn, that of Uranus, which is upright, and the asteroids.
pub(super) const RINGS: &[Ring] = &[
    SATURN,
    Ring {
        stones: 80,
        distance: 1.2,
        width: 0.05,
        period: 14.0,
        colour: [0.74, 0.64, 0.5],
        ..SATURN
    },
    Ring {
        planet: Some(6),
        stones: 30,
        stone: 0.028,
        distance: 0.72,
        width: 0.01,
        period: 8.0,
        tilt: 82.0,
        colour: [0.5, 0.6, 0.66],
    },
    Ring {
        planet: None,
        stones: 60,
        stone: 0.05,
        distance: 7.8,
        width: 0.2,
        period: 1680.0,
        tilt: 1.0,
        colour: [0.56, 0.5, 0.44],
    },
];
