//! Storage that a program in C owns: an array of words of fixed size, in which one part of the gearbox lives behind a mark that tells
//! whether it was set up.

use crate::status::Status;
use core::mem::MaybeUninit;

/// What lives in storage of C.
pub trait Stored: Sized {
    /// Words of 64 bits that the header gives it.
    const WORDS: usize;
    /// Mark of storage that holds one.
    const MARK: u64;
}

/// The storage, as the header declares it by its size.
#[repr(C)]
pub struct Slot<T> {
    mark: u64,
    value: MaybeUninit<T>,
}

impl<T: Stored> Slot<T> {
    const FITS: () = assert!(
        size_of::<Self>() <= 8 * T::WORDS && align_of::<Self>() <= align_of::<u64>(),
        "the header gives too little storage"
    );

    /// Puts a value into storage, whatever is there.
    pub(crate) fn put(slot: Option<&mut Self>, value: T) -> Result<(), Status> {
        let () = Self::FITS;
        let slot = slot.ok_or(Status::NullPointer)?;
        *slot = Self { mark: T::MARK, value: MaybeUninit::new(value) };
        Ok(())
    }

    /// The value in storage.
    pub(crate) fn value(slot: Option<&mut Self>) -> Result<&mut T, Status> {
        let slot = slot.ok_or(Status::NullPointer)?;
        if slot.mark != T::MARK {
            return Err(Status::NotInitialised);
        }
        // SAFETY: `put` alone writes the mark, together with the value.
        Ok(unsafe { slot.value.assume_init_mut() })
    }
}
