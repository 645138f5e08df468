package org.u2sa.service;

/** The run and kill of a service whose author writes only what happens in its loop. */
final class ServiceLoop {
  private static final long END_WITHIN_MS = 2_000;

  private final U2SAService service;

  ServiceLoop(U2SAService service) {
    this.service = service;
    service.life.endsSurely();
  }

  /**
   * {@link U2SAService#run}.
   *
   * @param begin called once, before anything else
   * @param loop returns when the service no longer runs
   */
  void run(ServiceHealth.CallbackCode begin, ServiceHealth.CallbackCode loop) {
    try {
      service.life.awaitTurn();
      service.log("running as thread " + service.threadID);
      service.handling.guarded(begin);
      loop.run();
    } catch (InterruptedException e) {
      service.log("interrupted, stopping");
    } catch (RuntimeException | Error e) {
      service.life.die(e);
    } finally {
      service.life.end();
    }
  }

  /** {@link U2SAService#kill}. */
  void kill() {
    service.life.stopWaiting();
    if (Thread.currentThread() == service) {
      return; // the loop ends after the present callback and closes everything
    }
    boolean interrupted = false;
    try {
      service.join(END_WITHIN_MS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    // A thread that was never started, or that hangs in its callback, cannot close its own
    // resources.
    service.life.end();
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
