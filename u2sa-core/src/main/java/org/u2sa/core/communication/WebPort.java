package org.u2sa.core.communication;

import java.net.InetSocketAddress;
import java.nio.file.Paths;
import java.util.Optional;
import java.util.function.Supplier;
import org.u2sa.core.communication.web.SameOrigin;
import org.u2sa.core.communication.web.WebResponses;
import org.u2sa.core.communication.web.WebSite;
import org.u2sa.core.communication.web.WebTiles;

/** Address and content of the operator's page served by the embedded broker. */
record WebPort(InetSocketAddress address, WebResponses page, SameOrigin origin, boolean encrypted) {
  /**
   * The web port of a configuration; empty without one.
   *
   * @throws org.u2sa.interfaces.BadInputException if there is no page to serve
   */
  static Optional<WebPort> of(ManagerVariables manager, Supplier<WebSite> page, boolean encrypted) {
    if (manager.webPort() == 0) {
      return Optional.empty();
    }
    InetSocketAddress address = new InetSocketAddress(manager.bindAddress(), manager.webPort());
    return Optional.of(
        new WebPort(
            address,
            new WebResponses(
                page.get(),
                manager.webTiles().isEmpty() ? null : WebTiles.open(Paths.get(manager.webTiles()))),
            SameOrigin.of(encrypted, address.getAddress()),
            encrypted));
  }

  /** Address for a browser on this host. */
  String link() {
    String host = address.getAddress().isAnyLocalAddress() ? "localhost" : address.getHostString();
    return (encrypted ? "https://" : "http://")
        + (host.contains(":") ? "[" + host + "]" : host)
        + ":"
        + address.getPort()
        + "/";
  }
}
