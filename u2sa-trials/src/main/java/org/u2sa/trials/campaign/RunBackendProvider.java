package org.u2sa.trials.campaign;

import java.nio.file.Path;

/**
 * Provides the backend of a type of cluster. A module registers its provider in {@code
 * META-INF/services/org.u2sa.trials.campaign.RunBackendProvider}; {@code u2sa campaign --master}
 * finds it through {@link java.util.ServiceLoader}.
 */
public interface RunBackendProvider {
  /**
   * Creates a backend for a cluster.
   *
   * @param master address of the cluster, as given to {@code --master}
   * @param directory the campaign's folder; {@code workers.log} there receives the log of the
   *     processes
   * @throws org.u2sa.interfaces.BadInputException if the address is invalid or unreachable, or
   *     required software is not installed
   */
  RunBackend at(String master, Path directory);
}
