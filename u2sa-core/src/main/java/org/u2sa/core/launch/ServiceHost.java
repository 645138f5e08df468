package org.u2sa.core.launch;

import java.util.Optional;
import org.u2sa.messages.contract.ServiceOrder;

/**
 * What a {@link Launcher} starts services with: the threads of its process, or processes. Called on
 * the launcher's thread, one order at a time; each call returns when the order is carried out.
 */
public interface ServiceHost {
  /**
   * Whether this host is the one to carry the order out. Every launcher of the system hears every
   * order; one obeys.
   */
  boolean isFor(ServiceOrder order);

  /**
   * Starts a service that does not run.
   *
   * @return why it was refused or could not be done; empty if it runs now
   */
  Optional<String> start(String serviceName);

  /**
   * Restarts a service, whatever state it is in, with its configuration read again.
   *
   * @return why it was refused or could not be done; empty if it runs now
   */
  Optional<String> restart(String serviceName);

  /**
   * Puts another class in the place of a service that runs.
   *
   * @param className full name of the class
   * @return why it was refused or could not be done; empty if the new one runs now
   */
  Optional<String> swap(String serviceName, String className);
}
