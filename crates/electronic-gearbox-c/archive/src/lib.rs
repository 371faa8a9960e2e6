//! The C interface of the electronic gearbox as a static library without std. The panic handler is never called: the tests look for it
//! in a linked program and find none.

#![no_std]

pub use electronic_gearbox_c::*;

#[panic_handler]
fn gearbox_panicked(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}

/// Tables of the compiler's own routines name this function where there is an operating system. Nothing unwinds through them.
#[cfg(not(target_os = "none"))]
#[unsafe(no_mangle)]
pub extern "C" fn rust_eh_personality() {}
