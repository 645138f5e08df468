package org.u2sa.core.communication;

import java.nio.file.Paths;
import org.u2sa.core.security.SecurityDirectory;
import org.u2sa.interfaces.communication.BrokerAccess;
import org.u2sa.interfaces.configuration.Configurator;

/** Credentials and encryption of this process's services at an external broker. */
record AccessVariables(String user, String passwordFile, boolean tls, String caFile) {
  static AccessVariables of(Configurator configuration) {
    return new AccessVariables(
        configuration.getVariable(BrokerAccess.USER),
        configuration.getVariable(BrokerAccess.PASSWORD_FILE),
        configuration.getVariable(BrokerAccess.TLS),
        configuration.getVariable(BrokerAccess.CA_FILE));
  }

  /** With the same configuration as the secured broker, its authority is the one to trust. */
  BrokerAccess beside(String directory) {
    String authority =
        caFile.isEmpty() && !directory.isEmpty()
            ? new SecurityDirectory(Paths.get(directory)).authority().toString()
            : caFile;
    return BrokerAccess.of(user, passwordFile, tls, authority);
  }
}
