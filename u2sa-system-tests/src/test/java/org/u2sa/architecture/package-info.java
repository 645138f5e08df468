/**
 * The rules of the house, checked on the classes of every module. A module's behaviour is tested
 * where the module stands.
 */
package org.u2sa.architecture;
