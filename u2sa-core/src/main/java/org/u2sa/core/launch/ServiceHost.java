package org.u2sa.core.launch;

import java.util.Optional;
import org.u2sa.messages.contract.ServiceOrder;

/**
 * Starts services for a {@link Launcher}, as threads of its process or as processes. Called on the
 * launcher's thread, one order at a time; each call returns when the order has been carried out.
 */
public interface ServiceHost {
  /**
   * Whether this host must carry the order out. Every launcher of the system receives every order;
   * exactly one obeys.
   */
  boolean isFor(ServiceOrder order);

  /**
   * Starts a service that is not running.
   *
   * @return reason for rejection or failure; empty if it runs now
   */
  Optional<String> start(String serviceName);

  /**
   * Restarts a service, whatever its state, and reloads its configuration.
   *
   * @return reason for rejection or failure; empty if it runs now
   */
  Optional<String> restart(String serviceName);

  /**
   * Replaces a running service by another class.
   *
   * @param className full name of the class
   * @return reason for rejection or failure; empty if the new one runs now
   */
  Optional<String> swap(String serviceName, String className);
}
