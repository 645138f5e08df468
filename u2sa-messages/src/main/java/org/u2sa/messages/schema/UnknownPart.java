package org.u2sa.messages.schema;

import java.util.List;
import java.util.Map;

/**
 * What the reader's classes cannot hold of a message.
 *
 * @param chain the message's own type chain
 * @param fields those beyond the known ancestor's, as read
 */
record UnknownPart(List<String> chain, Map<String, Object> fields) {}
