package org.u2sa.trials.campaign;

import java.util.List;

/**
 * A run for a {@link RunBackend} to execute.
 *
 * @param number unique number, from 1
 * @param arguments command-line arguments of {@code u2sa}, without {@code --out}
 * @param folder name of its output folder within the campaign's
 * @param keepsFiles whether to keep the files of a successful run; those of a failed run are always
 *     kept
 */
public record RunRequest(int number, List<String> arguments, String folder, boolean keepsFiles) {
  public RunRequest {
    arguments = List.copyOf(arguments);
  }
}
