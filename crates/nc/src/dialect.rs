//! The control dialects by name. Knows nothing of their grammar: writers and readers each have that on their own.

/// A control's language.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dialect {
    /// RS274/NGC as LinuxCNC reads it.
    LinuxCnc,
    /// The 840D family.
    Siemens,
    /// The 30i family.
    Fanuc,
}

impl Dialect {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::LinuxCnc, Self::Siemens, Self::Fanuc];

    /// Its name in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::LinuxCnc => "linuxcnc",
            Self::Siemens => "siemens",
            Self::Fanuc => "fanuc",
        }
    }

    /// Whether the axes stand while a digital output is switched ([`super::Block::Output`]), because the control carries out its
    /// statement between motions only.
    pub fn stands_to_switch(self) -> bool {
        self == Self::Fanuc
    }
}
