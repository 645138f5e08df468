package org.u2sa.service;

/** Sees from outside to the end of a service whose own thread does not. */
final class EndKeeper {
  private static final long ENDS_BY_ITSELF_WITHIN_MS = 200;
  private static final long RELEASES_WITHIN_MS = 2_000;

  private final LivingService service;

  EndKeeper(LivingService service) {
    this.service = service;
  }

  /** Begins to wait for the thread: should it just stop, the service ends as dead. */
  void watch() {
    helper("-watch", this::endAfterRun);
  }

  private Thread helper(String suffix, Runnable does) {
    Thread helper = new Thread(does, service.getName() + suffix);
    helper.setDaemon(true);
    helper.start();
    return helper;
  }

  private void endAfterRun() {
    try {
      service.join();
    } catch (InterruptedException e) { // nobody has this thread to interrupt it
      Thread.currentThread().interrupt();
      return;
    }
    service.die(new IllegalStateException("run() returned without end()"));
  }

  /** {@link LivingService#abandon}. */
  void abandon() {
    service.stopWaiting();
    service.interrupt();
    try {
      service.join(ENDS_BY_ITSELF_WITHIN_MS);
      helper("-abandoned", service::end).join(RELEASES_WITHIN_MS); // release may hang as well
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      service.wiring().close();
    }
  }
}
