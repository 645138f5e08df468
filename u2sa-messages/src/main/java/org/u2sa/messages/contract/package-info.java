/**
 * Messages that every service handles or sends regardless of its role: discovery, functionality,
 * stop, configuration, health (thesis 3.2.2.1, 3.5.3), and the announcements and commands for goals
 * and actuators. Measurements, plans and commands are in {@link org.u2sa.messages}.
 */
package org.u2sa.messages.contract;
