package org.u2sa.drivers.ioio;

import java.util.function.UnaryOperator;
import org.u2sa.interfaces.BadInputException;
import org.u2sa.interfaces.configuration.Description;
import org.u2sa.interfaces.configuration.Variable;
import org.u2sa.interfaces.mqtt.BrokerAccess;

/** Log-in to a board served over the network by {@code ./u2sa board} with users. */
record BoardLogin(
    @Variable(ifAbsentText = "") @Description("User name for a board at tls:host:port.")
        String user,
    @Variable(ifAbsentText = "") @Description("File whose first line is USER's password.")
        String passwordFile,
    @Variable(name = "CA FILE", ifAbsentText = "")
        @Description("Trusted CA certificates (PEM) for tls:host:port; empty: Java's defaults.")
        String authority) {
  private static final String SECURED = "tls:";

  /**
   * Connection for the variable CONNECTION.
   *
   * @param files resolves relative file names
   * @throws BadInputException if the address, the user or a file is invalid
   */
  BoardConnection connection(String address, UnaryOperator<String> files) {
    if (!address.startsWith(SECURED)) {
      return BoardConnection.of(address);
    }
    if (user.isEmpty() || passwordFile.isEmpty()) {
      throw new BadInputException(address + ": USER and PASSWORD FILE are also required");
    }
    String trusted = authority.isEmpty() ? "" : files.apply(authority);
    return PortConnection.at(
        address, BrokerAccess.of(user, files.apply(passwordFile), true, trusted));
  }
}
