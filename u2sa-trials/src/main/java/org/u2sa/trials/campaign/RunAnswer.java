package org.u2sa.trials.campaign;

/**
 * Answer of {@code u2sa} to a {@link RunRequest}.
 *
 * @param exit its exit code; {@link #LOST} if its processes died
 * @param output its standard output
 * @param errors its standard error
 */
public record RunAnswer(int exit, String output, String errors) {
  /** Exit code of a run whose processes died. */
  public static final int LOST = -1;

  /**
   * Answer for an abandoned run.
   *
   * @param why reason, such as "process 4711 of the campaign has died"
   */
  public static RunAnswer lost(String why) {
    return new RunAnswer(LOST, "", why);
  }
}
