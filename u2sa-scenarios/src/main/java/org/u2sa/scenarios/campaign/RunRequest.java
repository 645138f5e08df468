package org.u2sa.scenarios.campaign;

import java.util.List;

/**
 * One run that a {@link RunBackend} is to make.
 *
 * @param number from 1, no two alike
 * @param arguments what {@code u2sa} is told, without {@code --out}
 * @param folder name of the folder of its files, within the campaign's
 * @param keepsFiles whether they stay when the run succeeds; those of one that fails always do
 */
public record RunRequest(int number, List<String> arguments, String folder, boolean keepsFiles) {
  public RunRequest {
    arguments = List.copyOf(arguments);
  }
}
