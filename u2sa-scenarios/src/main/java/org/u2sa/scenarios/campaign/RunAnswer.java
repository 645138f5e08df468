package org.u2sa.scenarios.campaign;

/**
 * What {@code u2sa} answered to a {@link RunRequest}.
 *
 * @param exit its exit code; {@link #LOST} if no process lived to tell
 * @param output what it printed
 * @param errors what it said on standard error
 */
public record RunAnswer(int exit, String output, String errors) {
  /** Exit code of a run whose processes died. */
  public static final int LOST = -1;

  /**
   * A run that is given up.
   *
   * @param why such as "process 4711 of the campaign has died"
   */
  public static RunAnswer lost(String why) {
    return new RunAnswer(LOST, "", why);
  }
}
