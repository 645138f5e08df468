package org.u2sa.gcs.run;

/** Ends something in good order when the program is interrupted (Ctrl-C, TERM). */
final class EndOnInterrupt implements AutoCloseable {
  private final Thread hook;

  EndOnInterrupt(Runnable end) {
    hook = new Thread(end, "u2sa-end");
    Runtime.getRuntime().addShutdownHook(hook);
  }

  @Override
  public void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The program is ending already, which is what the hook is for: it runs now.
      return;
    }
  }
}
