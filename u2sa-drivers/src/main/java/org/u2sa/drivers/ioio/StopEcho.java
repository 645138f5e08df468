package org.u2sa.drivers.ioio;

import java.util.Optional;

/**
 * Determines whether the board has answered a query sent after a stop: the board executes messages
 * in order, so it has then stopped. Until then the stop is commanded but not confirmed. Called on
 * the service's thread.
 */
final class StopEcho {
  private static final long FRESH_ANSWERS = 2; // the first may answer an earlier query

  private Optional<BoardSession> stopped = Optional.empty(); // queried after the newest stop
  private long neededAnswers;

  /** Call after the stop has been sent. An absent board outputs nothing and starts neutral. */
  void stop(Optional<BoardSession> session) {
    stopped = session.filter(board -> board.answers().isPresent());
    if (stopped.isPresent()) {
      neededAnswers = stopped.get().answers().getAsLong() + FRESH_ANSWERS;
      stopped.get().askNow();
    }
  }

  /**
   * Whether the newest stop is known to have arrived. A board lost before answering may still
   * output pulses from its last commands, so only its return confirms the stop.
   */
  boolean isTaken(Optional<BoardSession> session) {
    if (stopped.isEmpty()) {
      return true;
    }
    if (session.isEmpty()) {
      return false;
    }
    BoardSession board = session.get();
    long needed = board == stopped.get() ? neededAnswers : FRESH_ANSWERS;
    if (board.answers().orElse(needed) < needed) {
      board.askNow();
      return false;
    }
    stopped = Optional.empty();
    return true;
  }
}
