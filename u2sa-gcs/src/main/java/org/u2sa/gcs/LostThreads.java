package org.u2sa.gcs;

import java.io.PrintWriter;

/**
 * Tells of threads that end by an exception that nobody caught. Paho's threads do when their client
 * is closed while it connects, as in a process that is told to end at its start: that is a line and
 * no stack trace, since the connection's end is noticed elsewhere.
 */
final class LostThreads implements Thread.UncaughtExceptionHandler {
  private static final String PAHO = "org.eclipse.paho.";

  private final PrintWriter err;

  LostThreads(PrintWriter err) {
    this.err = err;
  }

  @Override
  public void uncaughtException(Thread thread, Throwable thrown) {
    StackTraceElement[] trace = thrown.getStackTrace();
    boolean ofPaho =
        thrown instanceof RuntimeException
            && trace.length > 0
            && trace[0].getClassName().startsWith(PAHO);
    err.println("u2sa: thread " + thread.getName() + " ended: " + thrown);
    if (!ofPaho) {
      thrown.printStackTrace(err);
    }
    err.flush();
  }
}
