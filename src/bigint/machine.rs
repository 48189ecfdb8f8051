//! The sets of instructions for which loops over doubles are compiled.

use pulp::{Arch, Simd, WithSimd};

use crate::error::broken;

/// A set of instructions. The program uses that of its machine; tests use all others as well.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Machine {
    /// The best set of instructions of this machine.
    This(Arch),
    /// No vector instructions and no fused products; a library function rounds each product.
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
    /// The instructions of this machine.
    pub(crate) fn this() -> Self {
        Self::This(Arch::new())
    }

    /// All sets of instructions, beginning with that of this machine.
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

    /// Whether there are instructions for fused products. Without them a library function gives the same numbers, but takes
    /// about fifty times as long.
    pub(crate) fn has_fused_products(self) -> bool {
        match self {
            Self::This(arch) => !matches!(arch, Arch::Scalar),
            #[cfg(test)]
            _ => false,
        }
    }

    /// Runs an operation that is compiled for these instructions. It is called, not inlined: otherwise it would be compiled
    /// anew, for all sets of instructions, wherever a parallel loop is.
    #[inline(never)]
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

    /// Runs an operation that is only of use with fused products; the caller has made sure that there are some, by
    /// [`Machine::has_fused_products`]. It is not compiled for machines that have none.
    pub(crate) fn dispatch_fused<Op: WithSimd>(self, operation: Op) -> Op::Output {
        self.dispatch(Fused(operation))
    }
}

/// The operation of [`Machine::dispatch_fused`].
struct Fused<Op>(Op);

impl<Op: WithSimd> WithSimd for Fused<Op> {
    type Output = Op::Output;

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) -> Op::Output {
        // Where there are no vectors, there are no fused products. Tests check that the numbers are the same without them.
        if const { size_of::<S::f64s>() == size_of::<f64>() && !cfg!(test) } {
            broken("an operation with fused products is for a machine that has them");
        }
        self.0.with_simd(simd)
    }
}
