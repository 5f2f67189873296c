"""A contract of import-linter: layers in which lecture_* stands for every lecture, so that a new one need not be listed."""

from fnmatch import filter as matching

from importlinter.contracts.layers import Layer, LayersContract, ModuleTail
from importlinter.domain.helpers import module_expressions_to_modules


class LayersByPattern(LayersContract):
    """Layers whose names may contain `*`, which matches the modules of the containers."""

    type_name = "layers_by_pattern"

    def check(self, graph, verbose):
        containers = module_expressions_to_modules(graph, self.containers)
        names = [name.rpartition(".")[2] for container in containers for name in graph.find_children(container.name)]
        self.layers = [
            Layer(
                {ModuleTail(name) for tail in layer.module_tails for name in matching(names, tail.name) or [tail.name]},
                layer.is_independent,
            )
            for layer in self.layers
        ]
        return super().check(graph, verbose)
