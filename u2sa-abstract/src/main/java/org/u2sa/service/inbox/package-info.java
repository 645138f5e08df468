/** Messages that wait for a service, and how long it takes to handle them. */
package org.u2sa.service.inbox;
