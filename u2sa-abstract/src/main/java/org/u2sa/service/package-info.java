/**
 * Base classes of services (thesis 3.2.2, 8.2.3.1): U2SAService with its life cycle, inbox and
 * contract, and abstract sensors and actuators. Concrete services are in other modules.
 */
package org.u2sa.service;
