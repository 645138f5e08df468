package org.u2sa.core.security;

import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.u2sa.interfaces.communication.Topic;

/**
 * One user of the broker: a person, a service or a host.
 *
 * @param name 1…64 letters, digits, '_', '.' or '-'
 * @param roles at least one role; their permissions add up
 * @param systems accessible systems; at least one, or {@link #EVERY_SYSTEM} for all
 * @param password password hash
 */
public record User(
    String name, Set<AccessRole> roles, List<String> systems, PasswordHash password) {
  /** Stands for every system on the broker. */
  public static final String EVERY_SYSTEM = "*";

  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9_.-]{0,63}");
  private static final int PARTS = 4;

  /**
   * Checks the names.
   *
   * @throws IllegalArgumentException if one is invalid
   */
  public User {
    if (!NAME.matcher(name).matches()) {
      throw new IllegalArgumentException(
          "user \"" + name + "\": expected 1 to 64 letters, digits, '_', '.' or '-'");
    }
    if (roles.isEmpty() || systems.isEmpty()) {
      throw new IllegalArgumentException(
          "user \"" + name + "\": expected at least one role and one system");
    }
    for (String system : systems) {
      if (!system.equals(EVERY_SYSTEM)) {
        Topic.checkSystemId(system);
      }
    }
    roles = Set.copyOf(roles);
    systems = List.copyOf(systems);
  }

  /** Whether the user may publish and subscribe in the system. */
  public boolean mayEnter(String systemId) {
    return systems.contains(EVERY_SYSTEM) || systems.contains(systemId);
  }

  /** Whether the user may clear an emergency stop; others can only set one. */
  public boolean mayClearEmergencyStop() {
    return roles.contains(AccessRole.OPERATOR);
  }

  /** The names of the roles, joined by commas. */
  public String rolesText() {
    return roles.stream().sorted().map(AccessRole::text).collect(Collectors.joining(","));
  }

  /** Format of the users' file. */
  String line() {
    return name + ":" + rolesText() + ":" + String.join(",", systems) + ":" + password;
  }

  /** Parses the format of {@link #line}; throws IllegalArgumentException for any other. */
  static User parse(String line) {
    String[] parts = line.split(":", -1);
    if (parts.length != PARTS) {
      throw new IllegalArgumentException("expected name:roles:systems:password");
    }
    return new User(parts[0], rolesOf(parts[1]), listOf(parts[2]), PasswordHash.parse(parts[3]));
  }

  /**
   * Parses roles from a text such as {@code control,launcher}.
   *
   * @throws IllegalArgumentException if one is unknown
   */
  public static Set<AccessRole> rolesOf(String text) {
    Set<AccessRole> roles = EnumSet.noneOf(AccessRole.class);
    for (String name : listOf(text)) {
      roles.add(
          AccessRole.named(name)
              .orElseThrow(
                  () ->
                      new IllegalArgumentException(
                          "role \"" + name + "\": expected one of " + roleNames())));
    }
    return roles;
  }

  private static String roleNames() {
    return EnumSet.allOf(AccessRole.class).stream()
        .map(AccessRole::text)
        .collect(Collectors.joining(", "));
  }

  private static List<String> listOf(String text) {
    return Stream.of(text.split(","))
        .map(String::trim)
        .filter(part -> !part.isEmpty())
        .collect(Collectors.toList());
  }
}
