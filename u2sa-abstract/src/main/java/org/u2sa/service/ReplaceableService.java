package org.u2sa.service;

/**
 * The part of a service that hands its place over to another class while it runs (user story 8).
 */
abstract class ReplaceableService extends LivingService {
  private final Succession succession = new Succession();

  ReplaceableService(ServiceContext context, ServiceRole role, String serviceName) {
    super(context, role, serviceName);
  }

  /**
   * Writes down what a service of another class needs to know to take this one's place without a
   * bump: what was learnt since the start, such as the goal pursued or an integrator. Called on the
   * service's thread between two messages; this service goes on if the other one refuses.
   */
  protected void handOver(HandOver state) {}

  /**
   * Takes over what the service before it wrote down, which may be of any class of the same role.
   * Called once, before {@link #start} and only in a {@link ServiceSwap}. Nothing can be published
   * yet.
   *
   * @throws RuntimeException if the service cannot go on from there: the one before stays
   */
  protected void takeOver(HandOver state) {}

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
    atLast("closing", this::releaseSilently);
  }

  /** {@link #release} where nothing can be published. */
  void releaseSilently() {
    release();
  }

  /** Takes note of whose place it takes. */
  void succeeds(U2SAService predecessor) {
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
