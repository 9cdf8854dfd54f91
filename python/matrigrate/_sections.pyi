"""Made from scenario.schema.json by tools/stubs.py; do not edit.

Reading a parameter gives a number in the unit that its docstring names; writing takes such a number or a text with a unit.
A wrong name, unit or range raises matrigrate.ConfigurationError.
"""
from typing import Any, Literal

from ._schema import Parameter
from .errors import UnknownParameter
from .scenario import Scenario

class _Quantity:
    def __get__(self, section: Section, owner: Any = None) -> float: ...
    def __set__(self, section: Section, value: float | str) -> None: ...

class Section:
    """The parameters of one section of a scenario, as attributes.

    Reading gives a number in the documented unit; writing takes such a number, or a text with a unit."""
    def __init__(self, scenario: Scenario) -> None: ...

class Run(Section):
    """The run: how long, in which steps, with which random numbers."""
    duration: _Quantity
    """Simulated time; > 0 and <= 8760 h. A bare number is in h. Default: "6 h" (Heck et al. 2020, Methods)."""
    time_step: _Quantity
    """Time step, with the adaptive integrator the longest; left out: 0.4 s, adaptive 5 s (dt); > 0 and <= 60 s. A bare number is in s. Default: "0.4 s" (Heck et al. 2020, Table 1)."""
    integrator: Literal["reference", "adaptive"]
    """Steps of time_step throughout, or steps of up to time_step, halved where anything moves far; "reference" or "adaptive". Default: "reference" (MODEL.md, I29)."""
    seed: int
    """Seed of the random numbers: the same seed gives the same bits; >= 0 and <= 9007199254740991. Default: 1 (this program)."""
    threads: int
    """Threads to compute with, 0 for as many as the machine has; never changes a result; >= 0 and <= 1024. Default: 1 (this program)."""

class Ecm(Section):
    """The extracellular matrix."""
    @property
    def fields(self) -> EcmFields:
        """Fields of the matrix: values that differ from place to place."""
    youngs_modulus: _Quantity
    """Young's modulus of the intact matrix (E); > 0 and <= 1e7 Pa. A bare number is in Pa. Default: "200 Pa" (Heck et al. 2020, Table 1)."""
    poissons_ratio: float
    """Poisson's ratio of the intact matrix (nu); > 0 and < 0.5. Default: 0.45 (Heck et al. 2020, Table 1)."""
    viscosity: _Quantity
    """Viscosity of the matrix, intact or degraded (mu); > 0 and <= 1e9 Pa s. A bare number is in Pa s. Default: "1000 Pa s" (Heck et al. 2020, Table 1)."""
    radius: _Quantity
    """Radius of the disc of matrix, clamped at its rim; >= 10 and <= 2000 um. A bare number is in um. Default: "150 um" (Heck et al. 2020, Table 1)."""
    cell_hole: bool
    """Whether the disc of the cell and its margin of degradation start as fluid; true or false. Default: true (MODEL.md, I6)."""
    particle_spacing: _Quantity
    """Distance of neighbouring matrix particles (d_p); >= 0.1 and <= 50 um. A bare number is in um. Default: "2 um" (Heck et al. 2020, Table 1)."""
    smoothing_length: _Quantity
    """Smoothing length of the kernel, which reaches twice as far (h); >= 0.1 and <= 150 um. A bare number is in um. Default: "2.6 um" (Heck et al. 2020, Table 1)."""
    lattice: Literal["square", "hexagonal"]
    """Arrangement of the matrix particles at the start; "square" or "hexagonal". Default: "square" (MODEL.md, I2)."""
    thickness: _Quantity
    """Thickness of the plane model: a force per depth times it meets the forces of the cell (t_z); > 0 and <= 1000 um. A bare number is in um. Default: "1 um" (MODEL.md, I1)."""
    formulation: Literal["total_lagrangian", "updated_lagrangian"]
    """Whether the stress of the solid is summed over reference or over current neighbours; "total_lagrangian" or "updated_lagrangian". Default: "total_lagrangian" (MODEL.md, I4)."""
    hourglass_weight: float
    """Weight of the penalty against zero-energy modes of the particles (a_hg); >= 0 and <= 10. Default: 0.5 (MODEL.md, I5)."""
    support_floor: float
    """Smallest eigenvalue of the support tensor that is inverted as it is; > 0 and <= 1. Default: 0.3 (MODEL.md, I4)."""
    orphan_support: float
    """A solid particle with less than this share of its intact support becomes fluid; >= 0 and < 1. Default: 0.2 (MODEL.md, I7)."""
    density_min: float
    """Lower bound of the density over its initial value; > 0 and < 1. Default: 0.6 (MODEL.md, I7)."""
    density_max: float
    """Upper bound of the density over its initial value; > 1 and <= 10. Default: 1.8 (MODEL.md, I7)."""
    verlet_skin: _Quantity
    """Neighbours are listed up to this distance beyond the support; never changes a result; > 0 and <= 50 um. A bare number is in um. Default: "0.5 um" (this program)."""
    drag_lag: _Quantity
    """Displacement of a particle after which the drag coefficients of its tile are recomputed; scaled with the step by the adaptive integrator; >= 0 and <= 0.1 um. A bare number is in um. Default: "0.001 um" (MODEL.md, I30)."""

class EcmFields(Section):
    """Fields of the matrix: values that differ from place to place."""
    youngs_modulus: str
    """Young's modulus of the intact matrix from place to place, in place of ecm.youngs_modulus; a formula in x and y, or a file (.csv, .png, .tif), of values > 0 and <= 1e7 Pa. Default: "" (MODEL.md, I32)."""
    f_degr: str
    """Intact share of the matrix at the start: 1 solid, 0 fluid (channels, holes, tracks); a formula in x and y, or a file (.csv, .png, .tif), of values >= 0 and <= 1. Default: "" (MODEL.md, I32)."""
    ligand: str
    """Ligand on the solid over the usual one, which adhesions need: 0 where nothing adheres; a formula in x and y, or a file (.csv, .png, .tif), of values >= 0 and <= 100. Default: "" (MODEL.md, I35)."""
    attractant: str
    """Concentration of chemoattractant, in units of one's own; with cues.diffusion at the start and at the rim; a formula in x and y, or a file (.csv, .png, .tif), of values >= 0 and <= 1e6. Default: "" (MODEL.md, I34)."""
    attractant_source: str
    """Release of chemoattractant, concentration per second; a formula in x and y, or a file (.csv, .png, .tif), of values >= 0 and <= 1e6 1/s. Default: "" (MODEL.md, I34)."""
    obstacle: str
    """Rigid obstacles where it is 0.5 or more: they do not move and are never degraded (pillars, walls); a formula in x and y, or a file (.csv, .png, .tif), of values >= 0 and <= 1. Default: "" (MODEL.md, I33)."""

class Fibres(Section):
    """Strain-stiffening fibres of the matrix."""
    @property
    def field(self) -> FibresField:
        """Fields of the fibres."""
    arrangement: Literal["none", "isotropic", "uniaxial"]
    """Fibres between all neighbouring matrix particles, between those along one direction, or none; "none" or "isotropic" or "uniaxial". Default: "none" (Heck et al. 2020, Methods)."""
    direction_deg: _Quantity
    """Direction of uniaxial fibres, in degrees from the x axis; >= -180 and <= 180. A bare number is in deg. Default: 0 (Heck et al. 2020, Methods)."""
    half_angle_deg: _Quantity
    """Neighbours up to this far off the direction are joined by uniaxial fibres, in degrees; > 0 and <= 90. A bare number is in deg. Default: 30 (Heck et al. 2020, Methods)."""
    stiffness: _Quantity
    """Stiffness of the fibres below the onset of stiffening (k_0); >= 0 and <= 1e7 Pa. A bare number is in Pa. Default: "1000 Pa" (Heck et al. 2020, Table 1)."""
    onset: float
    """Strain of a fibre at which it begins to stiffen (eps_s); >= 0 and <= 10. Default: 0.075 (Heck et al. 2020, Table 1)."""
    stiffening_strain: float
    """Strain in which a stiffening fibre becomes stiffer by the factor e (d_s); >= 0.005 and <= 100. Default: 0.033 (Heck et al. 2020, Table 1)."""
    law: Literal["tangent", "secant"]
    """Whether Eq. 5 is the slope of a fibre's force over its strain, or the secant; "tangent" or "secant". Default: "tangent" (MODEL.md, I24)."""
    pull: Literal["axial", "vectorial"]
    """Whether a fibre pulls along itself, or along its change since the start; "axial" or "vectorial". Default: "axial" (MODEL.md, I23)."""
    plane_to_space: bool
    """Whether k_0 is taken times 8/15, as if the fibres were spread in space; true or false. Default: false (MODEL.md, I25)."""

class FibresField(Section):
    """Fields of the fibres."""
    direction_deg: str
    """Direction of uniaxial fibres from place to place, in place of fibres.direction_deg; a formula in x and y, or a file (.csv, .png, .tif), of values >= -360 and <= 360 deg. Default: "" (MODEL.md, I32)."""
    stiffness: str
    """Stiffness of the fibres from place to place, in place of fibres.stiffness; a formula in x and y, or a file (.csv, .png, .tif), of values >= 0 and <= 1e7 Pa. Default: "" (MODEL.md, I32)."""

class Cell(Section):
    """The cell."""
    radius: _Quantity
    """Radius of the cell at the start (R); > 0 and <= 500 um. A bare number is in um. Default: "15 um" (Heck et al. 2020, Table 1)."""
    centre_of_mass: Literal["area", "particles"]
    """Whether the centre of mass is that of the area inside the cortex or the mean of the cortex particles (x_cm); "area" or "particles". Default: "particles" (MODEL.md, I41)."""
    start_x: _Quantity
    """Centre of the cell at the start; >= -2000 and <= 2000 um. A bare number is in um. Default: "0 um" (this program)."""
    start_y: _Quantity
    """Centre of the cell at the start; >= -2000 and <= 2000 um. A bare number is in um. Default: "0 um" (this program)."""
    spring_stiffness: _Quantity
    """Stiffness of the springs of the cortex (k_s); >= 0 and <= 1 N/m. A bare number is in N/m. Default: "0.0028 N/m" (Heck et al. 2020, Table 1)."""
    dashpot: _Quantity
    """Viscosity of the dashpots of the cortex (eta_c); >= 0 and <= 1 N s/m. A bare number is in N s/m. Default: "0.0025 N s/m" (Heck et al. 2020, Table 1)."""
    bending_stiffness: _Quantity
    """Bending stiffness of the cortex (k_bend); >= 0 and <= 1e-12 N m. A bare number is in N m. Default: "5e-17 N m" (MODEL.md, I11)."""
    area_stiffness: _Quantity
    """Stiffness against shrinking below the initial area (k_A); >= 0 and <= 1000 N/m^2. A bare number is in N/m^2. Default: "0.71 N/m^2" (Heck et al. 2020, Table 1)."""
    liquid_drag: _Quantity
    """Drag of a particle of the cortex in the liquid, per depth (gamma_liquid); > 0 and <= 1e6 Pa s. A bare number is in Pa s. Default: "40 Pa s" (Heck et al. 2020, Table 1)."""
    repulsion_stiffness: _Quantity
    """Stiffness of the repulsion of the cortex from itself (k_rep); >= 0 and <= 1000 N/m^1.5. A bare number is in N/m^1.5. Default: "1.4 N/m^1.5" (Heck et al. 2020, Table 1)."""
    repulsion_distance: _Quantity
    """Range of the repulsion of the cortex from itself (d_rep); > 0 and <= 10 um. A bare number is in um. Default: "0.2 um" (Heck et al. 2020, Table 1)."""
    crowding: float
    """Fraction of its initial length below which a segment stiffens in compression; > 0 and < 1. Default: 0.5 (MODEL.md, I10)."""
    particles: int
    """Particles of the cortex; >= 20 and <= 10000. Default: 235 (Heck et al. 2020, Table 1)."""

class Contact(Section):
    """Contact of cell and matrix."""
    @property
    def cells(self) -> ContactCells:
        """Contact of cells with each other."""
    range: _Quantity
    """Range of the elastic contact with solid matrix (d_c); > 0 and <= 20 um. A bare number is in um. Default: "1.4 um" (MODEL.md, I13)."""
    fluid_share: float
    """Viscous coupling to fluid outside the cell, over that to solid; >= 0 and <= 1. Default: 0.15 (MODEL.md, I12)."""
    sample_spacing: _Quantity
    """Points of the viscous coupling on a segment are no further apart; >= 0.02 and <= 20 um. A bare number is in um. Default: "0.8 um" (MODEL.md, I12)."""
    deepest_solid: _Quantity
    """A solid particle deeper inside the cell becomes fluid at once; > 0 and <= 20 um. A bare number is in um. Default: "0.3 um" (MODEL.md, I13)."""

class ContactCells(Section):
    """Contact of cells with each other."""
    repulsion: _Quantity
    """Pressure between two cells whose cortices touch; > 0 and <= 1e7 Pa. A bare number is in Pa. Default: "500 Pa" (MODEL.md, I38)."""
    repulsion_range: _Quantity
    """Gap below which two cells repel each other; > 0 and <= 20 um. A bare number is in um. Default: "1 um" (MODEL.md, I38)."""
    adhesion: _Quantity
    """Largest pull per area between two cells, 0 for cells that do not stick to each other; >= 0 and <= 1e6 Pa. A bare number is in Pa. Default: "0 Pa" (MODEL.md, I39)."""
    adhesion_range: _Quantity
    """Width of the gaps, beyond contact.cells.repulsion_range, over which two cells pull at each other; > 0 and <= 20 um. A bare number is in um. Default: "1 um" (MODEL.md, I39)."""

class Nucleus(Section):
    """The nucleus of the cell; off in the paper."""
    radius: _Quantity
    """Radius of the nucleus at the start, 0 for a cell without one (R_n); >= 0 and <= 500 um. A bare number is in um. Default: "0 um" (MODEL.md, I40)."""
    shear_modulus: _Quantity
    """Shear modulus of the chromatin, which resists a change of shape; >= 0 and <= 1e7 Pa. A bare number is in Pa. Default: "100 Pa" (MODEL.md, I40)."""
    stretch_stiffness: _Quantity
    """Tension of the lamina over its strain; > 0 and <= 1000 nN. A bare number is in nN. Default: "0.5 nN" (MODEL.md, I40)."""
    bending_stiffness: _Quantity
    """Bending stiffness of the lamina; >= 0 and <= 1000 nN um^2. A bare number is in nN um^2. Default: "0.05 nN um^2" (MODEL.md, I40)."""
    bulk_modulus: _Quantity
    """Pressure in the nucleus over the lost share of its area; >= 0 and <= 1e7 Pa. A bare number is in Pa. Default: "5000 Pa" (MODEL.md, I40)."""
    retardation_time: _Quantity
    """Time in which lamina and chromatin give way to a load; >= 0 and <= 1e6 s. A bare number is in s. Default: "10 s" (MODEL.md, I40)."""
    centring_stiffness: _Quantity
    """Stiffness of the filaments that hold the nucleus in the middle of the cell; >= 0 and <= 1 N/m. A bare number is in N/m. Default: "2e-05 N/m" (MODEL.md, I40)."""
    drag: _Quantity
    """Drag of the nucleus in the cytoplasm, which moves with the cortex; >= 0 and <= 1000 N s/m. A bare number is in N s/m. Default: "0.001 N s/m" (MODEL.md, I40)."""
    repulsion: _Quantity
    """Pressure between nucleus and cortex where they touch; > 0 and <= 1e7 Pa. A bare number is in Pa. Default: "2000 Pa" (MODEL.md, I40)."""
    repulsion_range: _Quantity
    """Gap below which nucleus and cortex repel each other; > 0 and <= 20 um. A bare number is in um. Default: "0.5 um" (MODEL.md, I40)."""
    particles: int
    """Particles of the lamina; >= 12 and <= 2000. Default: 72 (MODEL.md, I40)."""

class Actomyosin(Section):
    """Contraction of the cortex."""
    force: _Quantity
    """Actomyosin force of a strand at full maturation (F_am); >= 0 and <= 1000 nN. A bare number is in nN. Default: "0.6 nN" (Heck et al. 2020, Table 1)."""
    f_mat_body: float
    """Maturation of the body of the cell (f_mat); >= 0 and <= 1. Default: 0.05 (Heck et al. 2020, Methods)."""
    curvature_optimum: _Quantity
    """Curvature at which a segment contracts most, convex positive (kappa_0); >= -100 and <= 100 1/um. A bare number is in 1/um. Default: "-0.15 1/um" (Heck et al. 2020, Table 1)."""
    curvature_width: _Quantity
    """Width of the curvature factor (kappa_w); > 0 and <= 100 1/um. A bare number is in 1/um. Default: "0.25 1/um" (Heck et al. 2020, Table 1)."""
    curvature_profile: Literal["gaussian", "half_gaussian", "triangle"]
    """Profile of the curvature factor: exp(-q^2), exp(-q^2/2), or max(0, 1 - |q|); "gaussian" or "half_gaussian" or "triangle". Default: "half_gaussian" (MODEL.md, I14)."""

class Protrusion(Section):
    """Initiation and growth of protrusions."""
    initiation_rate: _Quantity
    """Rate of initiation of each particle of the front (r_prot); >= 0 and <= 10 1/s. A bare number is in 1/s. Default: "6e-05 1/s" (Heck et al. 2020, Table 1)."""
    force: _Quantity
    """Force of growth, shared by the pushing particles (F_prot); >= 0 and <= 1000 nN. A bare number is in nN. Default: "0.32 nN" (Heck et al. 2020, Table 1)."""
    growth_time: _Quantity
    """Time of growth (T_prot); > 0 and <= 1e6 s. A bare number is in s. Default: "400 s" (Heck et al. 2020, Table 1)."""
    finishing_time: _Quantity
    """Time of contraction after the adhesion is gone (T_finish); >= 0 and <= 1e6 s. A bare number is in s. Default: "400 s" (Heck et al. 2020, Table 1)."""
    spring_stiffness: _Quantity
    """Stiffness of the springs of a growing or maturing protrusion (k_s,prot); >= 0 and <= 1 N/m. A bare number is in N/m. Default: "2.8e-06 N/m" (Heck et al. 2020, Table 1)."""
    deflection_rate: _Quantity
    """Rate at which growth turns towards degraded matrix (r_defl); >= 0 and <= 10 1/s. A bare number is in 1/s. Default: "0.1 1/s" (Heck et al. 2020, Table 1)."""
    number: int
    """Target number of simultaneous protrusions; 0: stochastic initiation at initiation_rate (n_prot); >= 0 and <= 100. Default: 0 (Heck et al. 2020, Methods)."""
    candidate_interval: _Quantity
    """With a target number: one candidate is drawn in each interval, whatever the time step; >= 0.01 and <= 10000 s. A bare number is in s. Default: "0.4 s" (Heck et al. 2020, Methods)."""
    rear_share: float
    """With a target number: chance of a rear particle over that of a front particle; >= 0 and <= 1. Default: 0.01 (Heck et al. 2020, Methods)."""
    area_limit: float
    """With a target number: area over A_0 beyond which none is initiated; > 1 and <= 100. Default: 2 (Heck et al. 2020, Methods)."""
    least_facing: float
    """A protrusion begins where its tip would feel at least this share of the growth force; >= 0 and <= 1. Default: 0.8 (MODEL.md, I16)."""
    growing_base: Literal["free", "tied"]
    """What holds the base of a growing protrusion: nothing, or a tie between its ends; "free" or "tied". Default: "tied" (MODEL.md, I16)."""
    half_width: int
    """Particles of a protrusion to each side of its centre (w_prot); >= 2 and <= 5000. Default: 20 (Heck et al. 2020, Table 1)."""
    tip_half_width: int
    """Pushing particles to each side of the centre (w_f); >= 0 and <= 5000. Default: 3 (Heck et al. 2020, Table 1)."""
    deflection_cone: _Quantity
    """Half opening of the cone ahead in which degraded matrix deflects growth; a bare number is in radians; > 0 and <= 180 deg. A bare number is in rad. Default: "60 deg" (MODEL.md, I17)."""
    spreading_rate: _Quantity
    """Rate at which growing particles slide towards equal spacing; >= 0 and <= 10 1/s. A bare number is in 1/s. Default: "0.5 1/s" (MODEL.md, I16)."""

class Adhesion(Section):
    """Adhesion, maturation and disassembly."""
    stiffness: _Quantity
    """Stiffness of the adhesion spring (k_ad); > 0 and <= 1 N/m. A bare number is in N/m. Default: "0.002 N/m" (Heck et al. 2020, Table 1)."""
    rest_length: _Quantity
    """Rest length of the adhesion spring (l_0,adh); >= 0 and <= 100 um. A bare number is in um. Default: "5 um" (Heck et al. 2020, Table 1)."""
    maturation_time: _Quantity
    """Time of maturation (T_mat); > 0 and <= 1e6 s. A bare number is in s. Default: "600 s" (Heck et al. 2020, Table 1)."""
    r_off_min: _Quantity
    """Rate of disassembly at high force (r_off,min); >= 0 and <= 10 1/s. A bare number is in 1/s. Default: "0.000278 1/s" (Heck et al. 2020, Table 1)."""
    r_off_0: _Quantity
    """Further rate of disassembly at zero force (r_off,0); >= 0 and <= 10 1/s. A bare number is in 1/s. Default: "0.2 1/s" (Heck et al. 2020, Table 1)."""
    zeta_diss: _Quantity
    """Sensitivity of disassembly to force (zeta_diss); >= 0 and <= 1e6 1/nN. A bare number is in 1/nN. Default: "20 1/nN" (Heck et al. 2020, Table 1)."""
    rupture: bool
    """Whether an adhesion breaks at rupture_ratio; off in the paper without fibres; true or false. Default: false (Heck et al. 2020, Methods)."""
    rupture_ratio: float
    """Force over f_mat F_am at which an adhesion breaks (f_rupt); > 0 and <= 1e6. Default: 1 (Heck et al. 2020, Table 1)."""
    rupture_strands: int
    """Strands of actomyosin whose full pull is the F_am of rupture and of f_adh_rel; >= 1 and <= 2. Default: 2 (MODEL.md, I28)."""
    step_threshold: float
    """Share of the force of a maturation step at which the next one begins; > 0 and <= 1. Default: 0.98 (Heck et al. 2020, Methods)."""
    rest_speed: _Quantity
    """Speed of the tip towards its base below which the recoil of growth is over and maturation steps begin to count; 0: they count at any speed; >= 0 and <= 1000 nm/s. A bare number is in nm/s. Default: "4 nm/s" (MODEL.md, I19)."""
    handover: Literal["immediate", "bundle"]
    """How the pull of maturation gives way to contraction: at once, or as the cortex takes over the load; "immediate" or "bundle". Default: "bundle" (MODEL.md, I20)."""
    handover_time: _Quantity
    """Time constant in which the pull of maturation gives way; > 0 and <= 10000 s. A bare number is in s. Default: "0.4 s" (MODEL.md, I20)."""
    handover_share: float
    """Share of f_mat F_am that the pull of maturation and the cortex together put on the adhesion; >= 0 and <= 1. Default: 0.9 (MODEL.md, I20)."""
    base_drag: _Quantity
    """Drag of each of six base particles while a protrusion matures; >= 0 and <= 1000 N s/m. A bare number is in N s/m. Default: "1 N s/m" (MODEL.md, I19)."""
    hold: Literal["place", "matter"]
    """Whether an adhesion hangs on the matrix that is near its anchor at a time, or on the matter that was there when it formed; "place" or "matter". Default: "matter" (MODEL.md, I18)."""
    spread: float
    """Smoothing length of the kernel that spreads an adhesion over the matrix, over that of the matrix; >= 0.8 and <= 4. Default: 1 (MODEL.md, I18)."""
    least_support: float
    """Share of solid around the anchor below which an adhesion is lost; > 0 and < 1. Default: 0.02 (MODEL.md, I18)."""

class Polarization(Section):
    """Polarization of the cell."""
    rate: _Quantity
    """Rate at which the polarization turns towards mature adhesions (r_pol); >= 0 and <= 10 1/s. A bare number is in 1/s. Default: "0.0011 1/s" (Heck et al. 2020, Table 1)."""
    turning: Literal["proportional", "constant"]
    """Whether the polarization turns in proportion to the angle or at constant speed; "proportional" or "constant". Default: "proportional" (MODEL.md, I21)."""

class Degradation(Section):
    """Degradation of the matrix by the cell."""
    tip_rate: _Quantity
    """Rate of degradation at the tip of a growing protrusion; >= 0 and <= 100 1/s. A bare number is in 1/s. Default: "0.2 1/s" (Heck et al. 2020, Table 1)."""
    tip_distance: _Quantity
    """Reach of degradation around the pushing particles (d_degr,tip); >= 0 and <= 100 um. A bare number is in um. Default: "2.4 um" (Heck et al. 2020, Table 1)."""
    protrusion_rate: _Quantity
    """Rate of degradation along a protrusion; >= 0 and <= 100 1/s. A bare number is in 1/s. Default: "0.033 1/s" (Heck et al. 2020, Table 1)."""
    protrusion_distance: _Quantity
    """Reach of degradation around a protrusion (d_degr,prot); >= 0 and <= 100 um. A bare number is in um. Default: "1.4 um" (Heck et al. 2020, Table 1)."""
    body_rate: _Quantity
    """Rate of degradation around the body of the cell; >= 0 and <= 100 1/s. A bare number is in 1/s. Default: "0.033 1/s" (Heck et al. 2020, Table 1)."""
    body_distance: _Quantity
    """Reach of degradation around the body of the cell (d_degr,cell); >= 0 and <= 100 um. A bare number is in um. Default: "1.9 um" (Heck et al. 2020, Table 1)."""
    threshold: _Quantity
    """Pressure above which protrusion and body degrade the matrix (p_th,degr); >= 0 and <= 1e6 Pa. A bare number is in Pa. Default: "20 Pa" (Heck et al. 2020, Table 1)."""
    pressure: Literal["larger", "solid", "sum"]
    """Whether the larger of solid and contact pressure is compared with the threshold, that of the solid, or their sum; "larger" or "solid" or "sum". Default: "sum" (MODEL.md, I15)."""

class Cues(Section):
    """What tells the cell where to begin protrusions; off in the paper."""
    chemotaxis: float
    """Protrusions begin exp(chemotaxis times the occupancy of receptors) times as often; negative: away from it; >= -1000 and <= 1000. Default: 0 (MODEL.md, I34)."""
    half_occupancy: float
    """Concentration at which half of the receptors bind, in the units of ecm.fields.attractant (K_d); > 0 and <= 1e9. Default: 1 (MODEL.md, I34)."""
    diffusion: _Quantity
    """Diffusion of the attractant, 0 for a steady field (D); >= 0 and <= 1e6 um^2/s. A bare number is in um^2/s. Default: "0 um^2/s" (MODEL.md, I34)."""
    decay: _Quantity
    """Rate at which the attractant decays, where it diffuses; >= 0 and <= 1000 1/s. A bare number is in 1/s. Default: "0 1/s" (MODEL.md, I34)."""
    uptake: _Quantity
    """Rate at which cells take up the attractant beneath them, where it diffuses; >= 0 and <= 1000 1/s. A bare number is in 1/s. Default: "0 1/s" (MODEL.md, I34)."""
    haptotaxis: float
    """Protrusions begin exp(haptotaxis times the ligand) times as often; >= -1000 and <= 1000. Default: 0 (MODEL.md, I35)."""
    guidance: float
    """Protrusions begin exp(guidance times cos 2a) times as often, a their angle to the fibres; >= -1000 and <= 1000. Default: 0 (MODEL.md, I36)."""

class Output(Section):
    """What a run writes, and how often."""
    track_interval: _Quantity
    """Time between rows of tracks.csv and health.csv; > 0 and <= 1e9 s. A bare number is in s. Default: "60 s" (this program)."""
    snapshot_interval: _Quantity
    """Time between snapshots; > 0 and <= 1e9 s. A bare number is in s. Default: "1800 s" (this program)."""
    checkpoint_interval: _Quantity
    """Time between checkpoints to resume from, 0 for one at the end and at signals only; >= 0 and <= 1e9 s. A bare number is in s. Default: "600 s" (this program)."""
    kept_checkpoint_interval: _Quantity
    """Time between checkpoints that are kept, to branch from, 0 for none; >= 0 and <= 1e9 s. A bare number is in s. Default: "3600 s" (this program)."""
    field_interval: _Quantity
    """Time between frames of cell and matrix in fields.h5 and in the report's player, 0 for none; >= 0 and <= 1e9 s. A bare number is in s. Default: "300 s" (this program)."""
    report: bool
    """Whether report.html is written; true or false. Default: true (this program)."""
    pictures: bool
    """Whether snapshots/ and snapshots.svg are drawn; true or false. Default: true (this program)."""
    displacement_layer: bool
    """Whether snapshots of the displacement of the matrix are drawn as well; true or false. Default: false (this program)."""
    fibre_stress_layer: bool
    """Whether snapshots of the von Mises stress of the fibres are drawn as well, where there are any; true or false. Default: true (this program)."""

class Solver(Section):
    """The linear system of every step."""
    method: Literal["multigrid", "conjugate_gradient"]
    """Conjugate gradients, with a multigrid cycle or with the diagonal as preconditioner; "multigrid" or "conjugate_gradient". Default: "multigrid" (this program)."""
    tolerance: float
    """Relative residual at which the drag system counts as solved; a hundred times it with multigrid and the adaptive integrator; > 0 and <= 0.1. Default: 0.0001 (this program)."""
    max_iterations: int
    """Iterations after which the solver gives up; >= 1 and <= 1e6. Default: 5000 (this program)."""

class Sections:
    """The sections of a scenario, as attributes."""
    @property
    def run(self) -> Run:
        """The run: how long, in which steps, with which random numbers."""
    @property
    def ecm(self) -> Ecm:
        """The extracellular matrix."""
    @property
    def fibres(self) -> Fibres:
        """Strain-stiffening fibres of the matrix."""
    @property
    def cell(self) -> Cell:
        """The cell."""
    @property
    def contact(self) -> Contact:
        """Contact of cell and matrix."""
    @property
    def nucleus(self) -> Nucleus:
        """The nucleus of the cell; off in the paper."""
    @property
    def actomyosin(self) -> Actomyosin:
        """Contraction of the cortex."""
    @property
    def protrusion(self) -> Protrusion:
        """Initiation and growth of protrusions."""
    @property
    def adhesion(self) -> Adhesion:
        """Adhesion, maturation and disassembly."""
    @property
    def polarization(self) -> Polarization:
        """Polarization of the cell."""
    @property
    def degradation(self) -> Degradation:
        """Degradation of the matrix by the cell."""
    @property
    def cues(self) -> Cues:
        """What tells the cell where to begin protrusions; off in the paper."""
    @property
    def output(self) -> Output:
        """What a run writes, and how often."""
    @property
    def solver(self) -> Solver:
        """The linear system of every step."""

classes: dict[str, type[Section]]

def help_text(p: Parameter) -> str: ...
def of(section: str) -> list[Parameter]: ...
def inner(section: str) -> list[str]: ...
def class_name(section: str) -> str: ...
def unknown(path: str, is_section: bool=False) -> UnknownParameter: ...
