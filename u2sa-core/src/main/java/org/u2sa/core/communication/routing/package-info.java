/** Which message goes to which subscriber, and which messages are retained. */
package org.u2sa.core.communication.routing;
