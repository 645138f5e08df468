package org.u2sa.service;

/** A service whose loop is written here, so that its author writes only what happens in it. */
abstract class LoopingService extends U2SAService {
  private static final long END_WITHIN_MS = 2_000;

  LoopingService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
  }

  /** The loop: returns when the service no longer runs. */
  abstract void loop() throws InterruptedException;

  /** Called once on the service's thread before its first message or step. */
  protected void begin() {}

  @Override
  public final void run() {
    try {
      awaitTurn();
      log("runs as thread " + threadID);
      guarded(this::begin);
      loop();
    } catch (InterruptedException e) {
      log("interrupted, ends");
    } catch (RuntimeException | Error e) {
      die(e);
    } finally {
      end();
    }
  }

  @Override
  final boolean endsSurely() {
    return true;
  }

  @Override
  public final void kill() {
    stopWaiting();
    if (Thread.currentThread() == this) {
      return; // the loop ends after the present callback and closes everything
    }
    boolean interrupted = false;
    try {
      join(END_WITHIN_MS);
    } catch (InterruptedException e) {
      interrupted = true;
    }
    // A thread that was never started, or that hangs in its callback, cannot close its own
    // resources.
    end();
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
