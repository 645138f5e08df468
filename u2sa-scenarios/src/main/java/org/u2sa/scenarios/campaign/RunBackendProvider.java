package org.u2sa.scenarios.campaign;

import java.nio.file.Path;

/**
 * Knows a kind of cluster. A module names its provider in {@code
 * META-INF/services/org.u2sa.scenarios.campaign.RunBackendProvider}; {@code u2sa campaign --master}
 * finds it through {@link java.util.ServiceLoader}.
 */
public interface RunBackendProvider {
  /**
   * What makes runs there.
   *
   * @param master address of the cluster, as {@code --master} has it
   * @param directory the campaign's folder; what processes say of themselves goes to {@code
   *     workers.log} there
   * @throws org.u2sa.interfaces.BadInputException if the address is none, nothing answers there, or
   *     something is not installed
   */
  RunBackend at(String master, Path directory);
}
