package org.u2sa.gcs.security;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.u2sa.interfaces.BadInputException;

/** Names and addresses of a host as they stand in its certificate. */
final class HostNames {
  private static final Pattern NAME =
      Pattern.compile("[A-Za-z0-9]([A-Za-z0-9-]{0,62})(\\.[A-Za-z0-9][A-Za-z0-9-]{0,62})*");
  private static final Pattern IPV4 = Pattern.compile("\\d{1,3}(\\.\\d{1,3}){3}");

  private HostNames() {}

  /** Those given, beside the ones that every broker's certificate has. */
  static List<String> with(List<String> given) {
    Set<String> names = new LinkedHashSet<>(List.of("localhost", "127.0.0.1", "::1"));
    ownName(names);
    names.addAll(given);
    names.forEach(HostNames::check);
    return new ArrayList<>(names);
  }

  private static void ownName(Set<String> names) {
    try {
      String own = InetAddress.getLocalHost().getHostName();
      if (NAME.matcher(own).matches()) {
        names.add(own);
      }
    } catch (UnknownHostException e) {
      return; // a host without a name is reached by those given
    }
  }

  private static void check(String name) {
    if (!isAddress(name) && !NAME.matcher(name).matches()) {
      throw new BadInputException(
          "host \"" + name + "\": expected a name such as vehicle.local, or an IP address");
    }
  }

  private static boolean isAddress(String name) {
    return name.indexOf(':') >= 0 && name.matches("[0-9A-Fa-f:.]+") || IPV4.matcher(name).matches();
  }

  /** As keytool's option takes them: {@code san=dns:…,ip:…}. */
  static String extension(List<String> names) {
    List<String> parts = new ArrayList<>();
    names.forEach(name -> parts.add((isAddress(name) ? "ip:" : "dns:") + name));
    return "san=" + String.join(",", parts);
  }
}
