package org.u2sa.drivers.link;

/** A daemon thread of a link. */
final class LinkThread {
  private final Thread thread;

  /** Starts the thread. */
  LinkThread(String name, Runnable work) {
    thread = new Thread(work, name);
    thread.setDaemon(true);
    thread.start();
  }

  /** Joins the thread; if the caller is interrupted, interrupts it and returns false. */
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
