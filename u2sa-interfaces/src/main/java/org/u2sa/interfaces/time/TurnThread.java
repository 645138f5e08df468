package org.u2sa.interfaces.time;

/** A thread that runs turns of other threads, for {@link Clock#runningThread}. */
interface TurnThread {
  /** The thread whose turn it runs, or this one if none. Called on this thread. */
  Thread lender();
}
