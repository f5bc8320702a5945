//! Objects in the form in which the PPU sends them: the records that the rays of a frame are
//! tested against.

use crate::stability::prelude::*;
use cellray::scene::RenderOptions;
use cellray::work::SceneBlock;
use protocol::layout::{Cone, Material, Object, Rectangle, SCENE_ADDRESS, Triangle};
use scenes::{LightKind, Shape};
use zerocopy::FromBytes as _;
use zerocopy::big_endian::F32;

/// The kinds of shape that SPUs trace.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Sphere,
    /// A parallelogram.
    Rectangle,
    Triangle,
    /// An open cone or cylinder.
    Cone,
}

impl Kind {
    /// Its index among a block's trees, and the size of its record in bytes.
    const fn record(self) -> (usize, usize) {
        match self {
            Self::Sphere => (0, size_of::<Object>()),
            Self::Rectangle => (1, size_of::<Rectangle>()),
            Self::Triangle => (2, size_of::<Triangle>()),
            Self::Cone => (3, size_of::<Cone>()),
        }
    }

    /// The number of words in its record.
    pub const fn words(self) -> usize {
        self.record().1 / 4
    }

    /// The kernel that intersects it.
    pub const fn kernel(self) -> &'static str {
        match self {
            Self::Sphere => "isect_sphere_pairs_r16",
            Self::Rectangle => "isect_rectangle_pairs_r16",
            Self::Triangle => "isect_triangle_pairs_r16",
            Self::Cone => "isect_cone_pairs_r16",
        }
    }
}

/// The records of an object and of its material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Product {
    /// The kind of shape.
    pub kind: Kind,
    /// The object's record, without the address of its material.
    pub object: Vec<u8>,
    /// The material's record.
    pub material: Vec<u8>,
}

/// The properties of a material.
#[derive(Clone, Copy, Debug)]
pub struct Stuff {
    /// The share of light that it reflects.
    pub mirror: f64,
    /// The share of light that it transmits.
    pub transmittance: f64,
    /// Index of refraction.
    pub index: f64,
}

/// The part with which all records begin.
pub struct Head {
    /// The object's centre.
    pub centre: Vector,
    /// The object's axis.
    pub axis: Vector,
    /// The signed radius of a sphere.
    pub offset: f64,
    /// The factor of the normal's part across the axis.
    pub gain: f64,
    /// The factor of the normal's part along the axis.
    pub slope: f64,
}

impl Product {
    /// The records that the PPU sends for a shape, with the eye at the origin. `None` if it does
    /// not send the shape as this kind.
    pub fn of(kind: Kind, shape: Shape, stuff: Stuff) -> Option<Self> {
        let scene = scenes::Scene {
            name: String::new(),
            view: scenes::View {
                from: DVec3::ZERO,
                at: DVec3::NEG_Z,
                up: DVec3::Y,
                angle: 45.0,
                hither: 1.0,
                resolution: (64, 64),
            },
            background: DVec3::ZERO,
            sky: None,
            ambient: DVec3::ZERO,
            lights: vec![scenes::Light {
                line: 0,
                kind: LightKind::Directional { to_light: DVec3::Z },
                colour: None,
            }],
            materials: vec![scenes::Material {
                line: 0,
                colour: DVec3::ONE,
                diffuse: 0.5,
                specular: stuff.mirror,
                shine: 10.0,
                transmittance: stuff.transmittance,
                refraction_index: stuff.index,
                emission: DVec3::ZERO,
                shader: scenes::Shader::Phong,
                texture: None,
            }],
            objects: vec![scenes::Object { line: 0, material: 0, shape }],
            mesh: None,
            heights: None,
            height_map: None,
            fog: None,
        };
        let block = SceneBlock::new(&scene, RenderOptions::default(), &|_| None).ok()?;
        let (tree, size) = kind.record();
        let tree = &block.bvhs()[tree];
        if tree.objects.get() != 1 {
            return None;
        }
        let record = |address: u32, size: usize| {
            let start = (address - SCENE_ADDRESS) as usize;
            block.bytes()[start..start + size].to_vec()
        };
        let object = record(tree.roots.get(), size);
        let (head, _) = Object::ref_from_prefix(&object).ok()?;
        let material = record(head.material.get(), size_of::<Material>());
        Some(Self { kind, object, material })
    }

    /// All of it as words.
    pub fn words(&self) -> impl Iterator<Item = u32> {
        let bytes = self.object.as_chunks().0.iter();
        let words = bytes.chain(self.material.as_chunks().0);
        words.map(|word| u32::from_be_bytes(*word))
    }

    /// The object that these words describe. There must be as many as the kind needs.
    pub fn from_words(kind: Kind, words: &[u32]) -> Self {
        let (object, material) = words.split_at(kind.words());
        let bytes = |words: &[u32]| words.iter().flat_map(|word| word.to_be_bytes()).collect();
        Self { kind, object: bytes(object), material: bytes(material) }
    }

    /// The number of words in an object of this kind.
    pub const fn word_count(kind: Kind) -> usize {
        kind.words() + size_of::<Material>() / 4
    }

    /// The head of its record in double precision.
    pub fn head(&self) -> Head {
        let (head, _) = Object::ref_from_prefix(&self.object).expect("records begin with a head");
        Head {
            centre: head.centre.map(exactly),
            axis: head.axis.map(exactly),
            offset: exactly(head.offset),
            gain: exactly(head.gain),
            slope: exactly(head.slope),
        }
    }

    /// The words of the record after its head.
    pub fn rest(&self) -> Vec<Single> {
        let words = self.object[size_of::<Object>()..].as_chunks().0.iter();
        words.map(|word| u32::from_be_bytes(*word)).collect()
    }
}

/// The value of a single in a record, in double precision.
pub fn exactly(single: F32) -> f64 {
    to_f64(bits(single))
}

/// Where a ray that starts inside a body, or on the outer side of it, next hits it, computed in
/// f64 from the record's own singles. `None` if it does not hit.
pub fn next_hit(product: &Product, origin: Vector, direction: Vector) -> Option<f64> {
    let head = product.head();
    let from = sub(origin, head.centre);
    match product.kind {
        // A ray that leaves a plane never hits it again.
        Kind::Rectangle | Kind::Triangle => None,
        Kind::Sphere => {
            let b = dot(from, direction);
            let l = add_scaled(from, -b, direction);
            let disc = head.offset * head.offset - dot(l, l);
            (disc >= 0.0).then(|| disc.sqrt() - b).filter(|t| *t > 0.0)
        }
        Kind::Cone => {
            let rest = product.rest();
            let [radius, growth, height] = [0, 1, 2].map(|word| to_f64(rest[word]));
            let split = |vector: Vector| {
                let height = dot(vector, head.axis);
                (height, add_scaled(vector, -height, head.axis))
            };
            let ((h, c), (rise, e)) = (split(from), split(direction));
            let (k, m) = (radius + growth * h, growth * rise);
            let (a, b) = (dot(e, e) - m * m, dot(c, e) - k * m);
            let v = add_scaled(e.map(|x| k * x), -m, c);
            let turn = cross(c, e);
            let disc = dot(v, v) - dot(turn, turn);
            let root = disc.max(0.0).sqrt();
            let q = if b < 0.0 { b - root } else { b + root };
            let out = dot(c, c) - k * k;
            let crossings = [-q / a, -out / q].into_iter();
            let on_body = |t: &f64| *t > 0.0 && (0.0..=height).contains(&(h + t * rise));
            crossings.filter(|_| disc > 0.0).filter(on_body).reduce(f64::min)
        }
    }
}
