/**
 * Many runs of one demo, over seeds and parameters, on all cores: what trust in a controller is
 * built on.
 */
package org.u2sa.scenarios.campaign;
