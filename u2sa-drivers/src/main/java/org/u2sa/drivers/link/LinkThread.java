package org.u2sa.drivers.link;

/** One of the threads of a link, which do not keep the process alive. */
final class LinkThread {
  private final Thread thread;

  /** Starts it. */
  LinkThread(String name, Runnable work) {
    thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
  }

  /** Waits for its end; false if the caller was interrupted, which then interrupts it. */
  boolean ended(int withinMs) {
    try {
      thread.join(withinMs);
      return true;
    } catch (InterruptedException e) {
      thread.interrupt();
      return false;
    }
  }
}
