//! Arrays that a program in C owns.

use crate::status::Status;

/// An array to read, which C keeps unchanged for as long as `'a`; an empty one may be a null pointer.
pub(crate) fn read<'a, T>(first: *const T, count: usize) -> Result<&'a [T], Status> {
    if count == 0 {
        return Ok(&[]);
    }
    check(first, count)?;
    // SAFETY: neither null nor unaligned nor beyond the address space; the header asks for `count` values that stay.
    Ok(unsafe { core::slice::from_raw_parts(first, count) })
}

/// An array to write.
pub(crate) fn write<'a, T>(first: *mut T, count: usize) -> Result<&'a mut [T], Status> {
    if count == 0 {
        return Ok(&mut []);
    }
    check(first, count)?;
    // SAFETY: as above; nothing else refers to it while the call lasts.
    Ok(unsafe { core::slice::from_raw_parts_mut(first, count) })
}

fn check<T>(first: *const T, count: usize) -> Result<(), Status> {
    if first.is_null() {
        return Err(Status::NullPointer);
    }
    let bytes = count.checked_mul(size_of::<T>()).filter(|bytes| *bytes <= isize::MAX as usize);
    if first.is_aligned() && bytes.is_some() { Ok(()) } else { Err(Status::BadParameter) }
}
