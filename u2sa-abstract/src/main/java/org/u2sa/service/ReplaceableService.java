package org.u2sa.service;

import java.io.IOException;
import java.util.Optional;
import org.u2sa.interfaces.log.LogLevelEnum;

/**
 * The part of a service that goes on where another one was: a service of another class while it
 * runs (user story 8), or itself before it was started anew.
 */
abstract class ReplaceableService extends LivingService {
  private final Succession succession = new Succession();
  private final ProgressFile progress;
  private boolean succeeded; // has its place from another service in this process
  private long notRemembered;

  ReplaceableService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
    progress = new ProgressFile(context, getServiceName());
  }

  /**
   * Writes down what a service of another class needs to know to take this one's place without a
   * bump: what was learnt since the start, such as the goal pursued or an integrator. Called on the
   * service's thread between two messages; this service goes on if the other one refuses.
   */
  protected void handOver(HandOver state) {}

  /**
   * Takes over what the service before it wrote down, which may be of any class of the same role.
   * Or what this service {@linkplain #remember remembered} before it was started anew. Called once,
   * before its thread runs, and not at a first start. Nothing can be published yet.
   *
   * @throws RuntimeException if the service cannot go on from there: in a {@link ServiceSwap} the
   *     one before stays; a restart fails, and the next one begins from nothing
   */
  protected void takeOver(HandOver state) {}

  /**
   * Keeps what {@link #handOver} writes at this moment, in a file beside the log. Should the
   * service be started anew in this run, in the same process or after its process was killed,
   * {@link #takeOver} gets it. Called on the service's thread at each change of what must not be
   * lost.
   */
  protected final void remember() {
    if (!isRunning() || wiring().isSilent()) {
      return; // given up or replaced: another one remembers now
    }
    try {
      HandOver state = new HandOver(getClass().getName());
      handOver(state);
      progress.write(state);
    } catch (IOException | RuntimeException e) { // such as a full disk: no reason not to go on
      notRemembered++;
      if (Long.bitCount(notRemembered) == 1) { // 1, 2, 4, 8…: it may last
        log(LogLevelEnum.ERROR, "a restart would not go on from here: " + e);
      }
    }
  }

  /** {@inheritDoc} One that was started anew goes on where it was. */
  @Override
  public void start() {
    if (!succeeded) {
      try {
        goOnOrBegin();
      } catch (IOException e) {
        log(LogLevelEnum.ERROR, "begins from nothing: " + e.getMessage());
      }
    }
    super.start();
  }

  private void goOnOrBegin() throws IOException {
    Optional<HandOver> before = context().isRestart() ? progress.read() : Optional.empty();
    if (before.isPresent()) {
      try {
        takeOver(before.get());
        log("goes on where it was before the restart");
        return;
      } catch (RuntimeException e) {
        logFile().log(LogLevelEnum.ERROR, "cannot go on from " + progress.path(), e);
        progress.delete();
        throw e;
      }
    }
    progress.delete(); // of another run
  }

  final Succession succession() {
    return succession;
  }

  @Override
  final void askToStop() {
    super.askToStop();
    succession.successor().ifPresent(U2SAService::askToStop); // which may take over just now
  }

  @Override
  final boolean handsOverInsteadOfEnding() {
    if (succession.successor().isPresent()) {
      return true;
    }
    succession.serviceEnds();
    return false;
  }

  /**
   * Closes what the subclass opened, but leaves actuators as they are: a successor moves them on.
   */
  final void releaseAsPredecessor() {
    atLast("closing", this::releaseToSuccessor);
  }

  /**
   * Closes what the subclass opened in a service whose place another one takes: in place of {@link
   * #release}, where nothing can be published. What moves is to be left as it is, because the
   * successor moves it on.
   */
  protected void releaseToSuccessor() {
    release();
  }

  /** Takes note of whose place it takes. */
  void succeeds(U2SAService predecessor) {
    succeeded = true;
    context().forgetPredecessor();
  }

  /** Starts; should that fail, it is over as if it had died. */
  final void startAsSuccessor() {
    try {
      start();
    } catch (RuntimeException | Error e) {
      die(e);
    }
  }

  /** Ends without ever having run, because its predecessor goes on. */
  final void discard() {
    if (endsNow()) {
      wiring().silence();
      releaseAsPredecessor();
      context().forgetPredecessor();
    }
  }
}
