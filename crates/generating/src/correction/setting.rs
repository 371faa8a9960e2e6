//! Settings of generating grinding that a correction may turn: names, units, what they cure and in which order they are chosen.

use foundation::geometry::Flank;

/// A setting and one of its parameters. q = (z_V2 - z_p)/(b/2) runs over the feed, u over the length of roll (-1 root, 1 tip).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Setting {
    /// d_k: Delta_d(z_V2) = sum d_k q^k, mm. 0 size, 1 taper, 2 equal crowning with its natural twist.
    RadialFeed(u8),
    /// phi_k: Delta_phi_2(z_V2) = sum phi_k q^k, rad. 0 index, 1 helix angle, 2 opposite crowning.
    WorkAngle(u8),
    /// Slope of the worm's profile: its f_n1 changes by -p u, mm. Profile slope of the gear flank: 2 p.
    ProfileSlope(Flank),
    /// Crowning of the worm's profile: its f_n1 changes by p u^2, mm. Profile crowning of the gear flank: p.
    ProfileCrown(Flank),
    /// Twist of the worm: its f_n1 changes by -t u v_X along the lines that the diagonal ratio lays on the flank, mm. S of the gear
    /// flank: -4 t.
    Twist(Flank),
    /// Worm shift z_V01, mm: where a topological pattern lies.
    WormShift,
    /// Diagonal ratio K: which direction a topological pattern has.
    DiagonalRatio,
}

/// Unit of a setting inside the library.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SettingUnit {
    /// mm.
    Length,
    /// rad.
    Angle,
    /// 1.
    Ratio,
}

/// When a setting is chosen: everything that an earlier one can remove is left to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Size and index.
    Size,
    /// Helix angle and taper.
    Lead,
    /// Profile angle and profile crowning: by dressing.
    Profile,
    /// Helix crowning through the worm, without twist, and twist.
    Topology,
    /// Crowning by the motion, only where the twist that it brings is wanted.
    NaturalTwist,
}

impl Setting {
    /// The twelve settings of both flanks in the order of `docs/mathematics/inspection.md`: d_0..2, phi_0..2, profile slope and crown left
    /// and right, twist left and right.
    pub const USUAL: [Self; 12] = [
        Self::RadialFeed(0),
        Self::RadialFeed(1),
        Self::RadialFeed(2),
        Self::WorkAngle(0),
        Self::WorkAngle(1),
        Self::WorkAngle(2),
        Self::ProfileSlope(Flank::Left),
        Self::ProfileCrown(Flank::Left),
        Self::ProfileSlope(Flank::Right),
        Self::ProfileCrown(Flank::Right),
        Self::Twist(Flank::Left),
        Self::Twist(Flank::Right),
    ];

    /// Stable name, without unit.
    pub fn name(self) -> String {
        match self {
            Self::RadialFeed(k) => format!("d{k}"),
            Self::WorkAngle(k) => format!("phi{k}"),
            Self::ProfileSlope(flank) => format!("profile_slope_{}", flank.name()),
            Self::ProfileCrown(flank) => format!("profile_crown_{}", flank.name()),
            Self::Twist(flank) => format!("twist_{}", flank.name()),
            Self::WormShift => "worm_shift".into(),
            Self::DiagonalRatio => "diagonal_ratio".into(),
        }
    }

    /// Its unit.
    pub fn unit(self) -> SettingUnit {
        match self {
            Self::WorkAngle(_) => SettingUnit::Angle,
            Self::DiagonalRatio => SettingUnit::Ratio,
            _ => SettingUnit::Length,
        }
    }

    /// When it is chosen.
    pub fn stage(self) -> Stage {
        match self {
            Self::RadialFeed(0) | Self::WorkAngle(0) => Stage::Size,
            Self::RadialFeed(1) | Self::WorkAngle(1) => Stage::Lead,
            Self::ProfileSlope(_) | Self::ProfileCrown(_) => Stage::Profile,
            Self::Twist(_) | Self::WormShift | Self::DiagonalRatio => Stage::Topology,
            Self::RadialFeed(_) | Self::WorkAngle(_) => Stage::NaturalTwist,
        }
    }

    /// Whether traces with zeros of their own leave it open: size and index come from thickness and pitch then.
    pub fn needs_absolute_zeros(self) -> bool {
        self.stage() == Stage::Size
    }

    /// The flank that it acts on; `None` for both.
    pub fn flank(self) -> Option<Flank> {
        match self {
            Self::ProfileSlope(flank) | Self::ProfileCrown(flank) | Self::Twist(flank) => Some(flank),
            _ => None,
        }
    }
}
