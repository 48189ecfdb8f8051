//! The instructions that loops over doubles are compiled for.

use pulp::{Arch, WithSimd};

/// A set of instructions: in the program that of this machine, in tests every other one as well.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Machine {
    /// The best set that this machine has.
    This(Arch),
    /// No vectors, and no fused products: each is rounded by a function of the library.
    #[cfg(test)]
    Scalar,
    /// Vectors of two doubles.
    #[cfg(test)]
    Of128Bits,
    /// Vectors of four doubles.
    #[cfg(test)]
    Of256Bits,
    /// Vectors of eight doubles.
    #[cfg(test)]
    Of512Bits,
}

impl Machine {
    /// This machine.
    pub(crate) fn this() -> Self {
        Self::This(Arch::new())
    }

    /// Every set of instructions, this machine's first.
    #[cfg(test)]
    pub(crate) fn all() -> [Self; 5] {
        [
            Self::this(),
            Self::Scalar,
            Self::Of128Bits,
            Self::Of256Bits,
            Self::Of512Bits,
        ]
    }

    /// Whether there are instructions for fused products: a function of the library gives the same numbers, and takes some fifty
    /// times as long.
    pub(crate) fn has_fused_products(self) -> bool {
        match self {
            Self::This(arch) => !matches!(arch, Arch::Scalar),
            #[cfg(test)]
            _ => false,
        }
    }

    /// Runs an operation that is compiled for these instructions.
    #[inline(always)]
    pub(crate) fn dispatch<Op: WithSimd>(self, operation: Op) -> Op::Output {
        match self {
            Self::This(arch) => arch.dispatch(operation),
            #[cfg(test)]
            Self::Scalar => operation.with_simd(pulp::Scalar),
            #[cfg(test)]
            Self::Of128Bits => operation.with_simd(pulp::Scalar128b),
            #[cfg(test)]
            Self::Of256Bits => operation.with_simd(pulp::Scalar256b),
            #[cfg(test)]
            Self::Of512Bits => operation.with_simd(pulp::Scalar512b),
        }
    }
}
