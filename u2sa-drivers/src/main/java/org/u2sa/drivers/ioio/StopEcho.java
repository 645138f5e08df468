package org.u2sa.drivers.ioio;

import java.util.Optional;

/**
 * Determines whether the board has answered a query sent after a stop: the board executes messages
 * in order, so it has then stopped. Until then, and while no board is connected, the stop is
 * commanded but not confirmed: a board behind a link that hangs goes on with its last pulses,
 * whether the link was lost before the stop or after it. Called on the service's thread.
 */
final class StopEcho {
  private static final long FRESH_ANSWERS = 2; // the first may answer an earlier query

  private boolean isAwaited;
  private Optional<BoardSession> asked = Optional.empty(); // after the newest stop
  private long neededAnswers;

  /** Call after the stop has been sent. */
  void stop(Optional<BoardSession> session) {
    isAwaited = true;
    asked = session;
    neededAnswers = session.map(board -> board.answers().orElse(0L)).orElse(0L) + FRESH_ANSWERS;
    session.ifPresent(BoardSession::askNow);
  }

  /** Whether the newest stop is known to have arrived. A board that comes back starts neutral. */
  boolean isTaken(Optional<BoardSession> session) {
    if (!isAwaited) {
      return true;
    }
    if (session.isEmpty()) {
      return false;
    }
    BoardSession board = session.get();
    boolean isAsked = asked.filter(before -> before == board).isPresent();
    long needed = isAsked ? neededAnswers : FRESH_ANSWERS;
    if (board.answers().orElse(needed) < needed) { // without answers: in lockstep
      board.askNow();
      return false;
    }
    isAwaited = false;
    asked = Optional.empty();
    return true;
  }
}
