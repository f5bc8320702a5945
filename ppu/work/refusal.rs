//! The meaning of an SPU's status: the field that it refused, and the field's value.

use std::fmt;

use zerocopy::IntoBytes as _;

use protocol::layout::{Frame, RULE_KNOWN, RULE_LANES, RULE_REGISTER, RULE_STACK, Status};

/// An SPU's reply that isn't "done".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The status word.
    pub status: u32,
    /// The refused field of the frame's record or of a work unit; empty if the status is unknown.
    pub field: &'static str,
    rule: &'static str,
    values: Vec<u64>,
    /// The number of the mesh's block that was refused.
    block: Option<u32>,
    shader: Option<ShaderFault>,
}

/// The fault of a shader. The reply has the broken rule in the second lowest byte, the register
/// above it, and the shader in the highest byte.
#[derive(Clone, Debug, PartialEq, Eq)]
struct ShaderFault {
    rule: u32,
    register: u32,
    /// The shader's number; `name` is its name, if it has one.
    shader: u32,
    name: Option<String>,
}

impl Refusal {
    /// Whether the refusal is a shader's fault, and its message names the shader.
    #[must_use]
    pub fn names_shader(&self) -> bool {
        self.shader.is_some()
    }

    /// Decodes a reply; `None` means "done". `shaders` are the names of the program's shaders.
    #[must_use]
    pub fn of(reply: u32, frame: &Frame, address: u64, shaders: &[String]) -> Option<Self> {
        if reply == Status::Done as u32 {
            return None;
        }
        let [shader, register, rule, status] = reply.to_be_bytes().map(u32::from);
        if status == Status::Shader as u32 && (RULE_KNOWN..=RULE_LANES).contains(&rule) {
            return Some(Self {
                status,
                field: "",
                rule: "",
                values: Vec::new(),
                block: None,
                shader: Some(ShaderFault {
                    rule,
                    register,
                    shader,
                    name: shaders.get(shader as usize).cloned(),
                }),
            });
        }
        // A status of a block has the block's number in the higher bytes.
        let block = (status == Status::MeshBlock as u32).then_some(reply >> 8);
        let reply = block.map_or(reply, |_| status);
        let known = Status::ALL.iter().find(|(_, status, ..)| *status as u32 == reply);
        let Some(&(_, status, field, rule)) = known else {
            return Some(Self {
                status: reply,
                field: "",
                rule: "",
                values: Vec::new(),
                block: None,
                shader: None,
            });
        };
        let values = if block.is_some() {
            Vec::new()
        } else if status == Status::Address {
            vec![address]
        } else {
            field.split(", ").filter_map(|field| value_of(frame, field)).collect()
        };
        Some(Self { status: reply, field, rule: rule.trim(), values, block, shader: None })
    }
}

/// The value of a field of the frame's record, by its name.
fn value_of(frame: &Frame, name: &str) -> Option<u64> {
    let field = Frame::RECORD.fields.iter().find(|field| field.name == name)?;
    if field.size > size_of::<u64>() {
        return None;
    }
    let bytes = frame.as_bytes().get(field.offset..field.offset + field.size)?;
    Some(bytes.iter().fold(0, |value, byte| value << 8 | u64::from(*byte)))
}

impl fmt::Display for ShaderFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, register, shader, name } = self;
        if *rule == RULE_KNOWN {
            return write!(f, "has no shader {shader}, which a material names");
        }
        match name {
            Some(name) => write!(f, "found that the shader {name} breaks its contract: it ")?,
            None => write!(f, "found that shader {shader} breaks its contract: it ")?,
        }
        match *rule {
            RULE_REGISTER => write!(f, "changed ${register}, which it must preserve"),
            RULE_STACK => write!(f, "wrote below its 1024 bytes of stack"),
            _ => write!(f, "changed surfaces that it must not shade"),
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(fault) = &self.shader {
            return fault.fmt(f);
        }
        if self.field.is_empty() {
            return write!(f, "replied with the unknown status {}", self.status);
        }
        if let Some(block) = self.block {
            write!(f, "refused block {block} of the mesh")?;
        } else if self.status == Status::Tile as u32 {
            write!(f, "refused the work units: {}", self.field)?;
        } else if self.values.is_empty() {
            write!(f, "refused the frame descriptor: {}", self.field)?;
        } else {
            write!(f, "refused the frame descriptor: {} is ", self.field)?;
        }
        for (number, value) in self.values.iter().enumerate() {
            let comma = if number == 0 { "" } else { ", " };
            write!(f, "{comma}{value} ({value:#x})")?;
        }
        let mut rule = self.rule.chars();
        let first = rule.next().map(|first| first.to_ascii_lowercase());
        write!(
            f,
            ": {}{}",
            first.into_iter().collect::<String>(),
            rule.as_str().trim_end_matches('.')
        )
    }
}

#[cfg(test)]
mod tests {
    use zerocopy::FromZeros as _;

    use super::{Frame, RULE_KNOWN, RULE_LANES, RULE_REGISTER, RULE_STACK, Refusal, Status};

    fn message(rule: u32, register: u32, shader: u32) -> String {
        let reply = Status::Shader as u32 | rule << 8 | register << 16 | shader << 24;
        let names = ["checker", "depth"].map(String::from);
        let refusal = Refusal::of(reply, &Frame::new_zeroed(), 0, &names);
        refusal.expect("a reply other than done").to_string()
    }

    #[test]
    fn message_names_the_shader_and_the_broken_rule() {
        assert_eq!(
            message(RULE_REGISTER, 90, 1),
            "found that the shader depth breaks its contract: it changed $90, which it must preserve"
        );
        assert_eq!(
            message(RULE_STACK, 0, 7),
            "found that shader 7 breaks its contract: it wrote below its 1024 bytes of stack"
        );
        assert_eq!(
            message(RULE_LANES, 0, 0),
            "found that the shader checker breaks its contract: it changed surfaces that it must not shade"
        );
        assert_eq!(message(RULE_KNOWN, 0, 255), "has no shader 255, which a material names");
        assert_eq!(message(9, 1, 1), "replied with the unknown status 16845084");
    }
}
