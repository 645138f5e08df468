package org.u2sa.service;

import java.util.Optional;

/** Records the executions of services created after it, such as a recorder. */
public interface ExecutionKeeper {
  /** Called before a service of that class is created; empty if it is not recorded. */
  Optional<Execution> keep(String className, ServiceContext context);
}
