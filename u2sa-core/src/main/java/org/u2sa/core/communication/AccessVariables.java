package org.u2sa.core.communication;

import java.nio.file.Paths;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.BrokerAccess;
import org.u2sa.interfaces.configuration.Configurator;

/** How the services of this process log in to an external broker. */
record AccessVariables(BrokerAccess.Login login) {
  static AccessVariables of(Configurator configuration) {
    return new AccessVariables(configuration.settings(BrokerAccess.Login.class).get());
  }

  /** With the same configuration as the secured broker, its authority is the one to trust. */
  BrokerAccess beside(String directory) {
    String authority =
        login.authority().isEmpty() && !directory.isEmpty()
            ? new SecurityDirectory(Paths.get(directory)).authority().toString()
            : login.authority();
    return BrokerAccess.of(login.user(), login.passwordFile(), login.tls(), authority);
  }
}
