package org.u2sa.service.directory;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * A channel that a service offers, with the type chain of its messages' base type; as text {@code
 * state/StateInformation}.
 *
 * @param typeChain topmost type first; empty: any message
 */
public record DataOffer(String channel, List<String> typeChain) {
  /**
   * Parses {@code channel/TypeChain}. Other text is taken as a channel name, because it may come
   * from services of another version.
   */
  public static DataOffer parse(String text) {
    List<String> parts = new ArrayList<>(Arrays.asList(text.split("/")));
    parts.removeIf(String::isEmpty);
    return parts.isEmpty()
        ? new DataOffer(text, Collections.emptyList())
        : new DataOffer(parts.get(0), Collections.unmodifiableList(parts.subList(1, parts.size())));
  }

  /** Name of the base type; {@code any} for any message. */
  public String typeName() {
    return typeChain.isEmpty() ? "any" : typeChain.get(typeChain.size() - 1);
  }

  /** Whether all messages of the channel are of the type. */
  public boolean isAlways(List<String> wanted) {
    return !wanted.isEmpty() && startsWith(typeChain, wanted);
  }

  /**
   * {@link #isAlways}, or the type is a subclass of the channel's. Channels for any message do not
   * count.
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
