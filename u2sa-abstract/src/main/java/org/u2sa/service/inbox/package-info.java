/** Message queue of a service, and the measurement of callback times. */
package org.u2sa.service.inbox;
