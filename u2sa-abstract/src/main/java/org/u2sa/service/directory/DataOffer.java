package org.u2sa.service.directory;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * One line of a service's functionality: a channel, and the base type of what travels on it with
 * all its ancestors. As text {@code state/StateInformation}.
 *
 * @param channel the channel's name
 * @param typeChain the base type of what travels there and its ancestors, base first; empty: any
 *     message
 */
public record DataOffer(String channel, List<String> typeChain) {
  /**
   * Reads {@code channel/TypeChain}; a channel of any message has no chain. What is not of that
   * form is taken for a channel's name, since it comes from services that may be of another
   * version.
   */
  public static DataOffer parse(String text) {
    List<String> parts = new ArrayList<>(Arrays.asList(text.split("/")));
    parts.removeIf(String::isEmpty);
    return parts.isEmpty()
        ? new DataOffer(text, Collections.emptyList())
        : new DataOffer(parts.get(0), Collections.unmodifiableList(parts.subList(1, parts.size())));
  }

  /** The name of the base type of what travels there; {@code any} for any message. */
  public String typeName() {
    return typeChain.isEmpty() ? "any" : typeChain.get(typeChain.size() - 1);
  }

  /** Whether all that travels there is of the type: it is the channel's type or an ancestor. */
  public boolean isAlways(List<String> wanted) {
    return !wanted.isEmpty() && startsWith(typeChain, wanted);
  }

  /**
   * Whether messages of the type may travel there: besides {@link #isAlways}, the type is a
   * subclass of the channel's. A channel of any message says nothing of what it carries, so that it
   * does not count.
   */
  public boolean mayBe(List<String> wanted) {
    return isAlways(wanted) || !typeChain.isEmpty() && startsWith(wanted, typeChain);
  }

  private static boolean startsWith(List<String> chain, List<String> beginning) {
    return chain.size() >= beginning.size() && chain.subList(0, beginning.size()).equals(beginning);
  }

  @Override
  public String toString() {
    return typeChain.isEmpty() ? channel : channel + "/" + String.join("/", typeChain);
  }
}
