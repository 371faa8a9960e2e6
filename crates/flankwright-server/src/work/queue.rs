//! Runs that wait for their turn, in a bounded queue. A place in it is taken before a run is stored, so that no run is stored that cannot
//! wait; who is cancelled leaves it at once.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

/// Runs that may wait.
pub const MOST_WAITING: usize = 32;

/// The queue.
#[derive(Debug, Default)]
pub struct Queue {
    state: Mutex<State>,
    come: Condvar,
}

#[derive(Debug, Default)]
struct State {
    waiting: VecDeque<i64>,
    reserved: usize,
    ending: bool,
}

/// A place in the queue; free again when it is dropped.
#[derive(Debug)]
pub struct Place(Arc<Queue>);

impl Queue {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// A place, if there is one and the server does not end.
    pub fn reserve(self: &Arc<Self>) -> Option<Place> {
        let mut state = self.state();
        if state.ending || state.waiting.len() + state.reserved >= MOST_WAITING {
            return None;
        }
        state.reserved += 1;
        Some(Place(self.clone()))
    }

    /// The next run, as soon as there is one; `None` when the server ends.
    pub fn next(&self) -> Option<i64> {
        let mut state = self.state();
        loop {
            if state.ending {
                return None;
            }
            if let Some(id) = state.waiting.pop_front() {
                return Some(id);
            }
            state = self.come.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Takes a run out that waits. `false` if it does not.
    pub fn take_back(&self, id: i64) -> bool {
        let mut state = self.state();
        let place = state.waiting.iter().position(|&waiting| waiting == id);
        place.and_then(|place| state.waiting.remove(place)).is_some()
    }

    /// How many wait.
    pub fn waiting(&self) -> usize {
        self.state().waiting.len()
    }

    /// Closed: no run is accepted or started any more.
    pub fn end(&self) {
        self.state().ending = true;
        self.come.notify_all();
    }

    /// Whether the server ends.
    pub fn is_ending(&self) -> bool {
        self.state().ending
    }
}

impl Place {
    /// A run takes it.
    pub fn fill(self, id: i64) {
        self.0.state().waiting.push_back(id);
        self.0.come.notify_one();
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        self.0.state().reserved -= 1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_and_come_back() {
        let queue = Arc::new(Queue::default());
        let mut places: Vec<Place> = (0..MOST_WAITING).map_while(|_| queue.reserve()).collect();
        assert_eq!((places.len(), queue.reserve().is_some()), (MOST_WAITING, false));
        for id in 0..3 {
            places.pop().unwrap().fill(id);
        }
        assert_eq!((queue.waiting(), queue.reserve().is_some()), (3, false));
        assert!(queue.take_back(1) && !queue.take_back(1));
        assert_eq!((queue.next(), queue.next()), (Some(0), Some(2)));
        drop(places);
        assert_eq!((0..100).map_while(|_| queue.reserve()).collect::<Vec<_>>().len(), MOST_WAITING);
        queue.end();
        assert!(queue.next().is_none() && queue.reserve().is_none());
    }
}
