package org.u2sa.core.communication.web;

import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpHeaders;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * Decides whether a request is meant for this server and comes from its own page. A browser lets
 * any page connect to any server, and gives the page in the Origin header (RFC 6455, section 10.2);
 * DNS rebinding, which points a page's host name at this host, is detected by the Host header.
 */
public final class SameOrigin {
  private static final Pattern ADDRESS =
      Pattern.compile("[0-9]{1,3}(\\.[0-9]{1,3}){3}|\\[[0-9a-f:.]+\\]");
  private static final Pattern PORT = Pattern.compile(":[0-9]{1,5}$");
  private static final Set<String> LOOPBACK = Set.of("localhost", "127.0.0.1", "[::1]");

  private final boolean isEncrypted;
  private final boolean isLocal;
  private final Set<String> names;

  private SameOrigin(boolean isEncrypted, boolean isLocal, Set<String> names) {
    this.isEncrypted = isEncrypted;
    this.isLocal = isLocal;
    this.names = names;
  }

  /**
   * Creates the rule for a server.
   *
   * @param isEncrypted whether it uses TLS; its certificate then contains its names
   * @param bound address on which it listens
   */
  public static SameOrigin of(boolean isEncrypted, InetAddress bound) {
    Set<String> names = new HashSet<>(LOOPBACK);
    if (!bound.isLoopbackAddress()) {
      try {
        String own = InetAddress.getLocalHost().getHostName().toLowerCase(Locale.ROOT);
        names.addAll(List.of(own, own + ".local"));
      } catch (UnknownHostException e) {
        return new SameOrigin(isEncrypted, false, names); // without a name: reached by address only
      }
    }
    return new SameOrigin(isEncrypted, bound.isLoopbackAddress(), names);
  }

  /** Whether the request names this server: by its address or one of its own names. */
  boolean isHost(HttpHeaders headers) {
    List<String> hosts = headers.getAll(HttpHeaderNames.HOST);
    if (hosts.size() != 1) {
      return false;
    }
    String host = PORT.matcher(hosts.get(0).toLowerCase(Locale.ROOT)).replaceFirst("");
    return names.contains(host)
        || isEncrypted && !isLocal
        || !isLocal && ADDRESS.matcher(host).matches()
        || isLocal && host.startsWith("127.") && ADDRESS.matcher(host).matches();
  }

  /** Whether a request comes from a page of this server; false without an Origin header. */
  boolean isOwnPage(HttpHeaders headers) {
    String own = (isEncrypted ? "https://" : "http://") + headers.get(HttpHeaderNames.HOST, "");
    List<String> origins = headers.getAll(HttpHeaderNames.ORIGIN);
    return origins.size() == 1 && own.equalsIgnoreCase(origins.get(0));
  }
}
